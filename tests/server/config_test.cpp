// The options' table: names, defaults, ranges at both ends, and who wins.
#include "server/config.h"

#include <cstdlib>

#include "server/text_form.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

struct Numeric {
  const char* name;
  const char* flag;
  const char* variable;
  std::int64_t standard, least, most;
  std::int64_t (*of)(const Config&);
};

void PrintTo(const Numeric& option, std::ostream* out) { *out << option.name; }

const Numeric numerics[] = {
    {"port", "--port", "TIA_PORT", 8080, 0, 65535,
     [](const Config& c) -> std::int64_t { return c.port; }},
    {"threads", "--threads", "TIA_THREADS", Config::processors(), 1, 64,
     [](const Config& c) -> std::int64_t { return c.threads; }},
    {"max_body_bytes", "--max-body-bytes", "TIA_MAX_BODY_BYTES", 4'194'304, 1024, 1'073'741'824,
     [](const Config& c) { return c.max_body_bytes; }},
    {"max_scenes_bytes", "--max-scenes-bytes", "TIA_MAX_SCENES_BYTES", 67'108'864, 0,
     1'099'511'627'776, [](const Config& c) { return c.max_scenes_bytes; }},
    {"max_rays", "--max-rays", "TIA_MAX_RAYS", 2'000'000'000, 1, 1'000'000'000'000'000,
     [](const Config& c) { return c.max_rays; }},
    {"max_work", "--max-work", "TIA_MAX_WORK", 10'000'000'000, 1, 1'000'000'000'000'000,
     [](const Config& c) { return c.max_work; }},
    {"max_pixels", "--max-pixels", "TIA_MAX_PIXELS", 16'777'216, 1, 268'435'456,
     [](const Config& c) { return c.max_pixels; }},
};

Config read(const std::string& name, const std::string& text) {
  return read_config({{name, text, "--some-flag"}});
}
// What read_config says against the text; "" where it takes it.
std::string refusal(const std::string& name, const std::string& text) {
  try {
    read(name, text);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

class Option : public testing::TestWithParam<Numeric> {};

TEST_P(Option, IsOneRowOfTheTable) {
  const Numeric& option = GetParam();
  for (const OptionRow& row : option_rows()) {
    if (row.name != option.name) continue;
    EXPECT_EQ(row.flag, option.flag);
    EXPECT_EQ(row.variable, option.variable);
    EXPECT_EQ(row.default_text, std::to_string(option.standard));
    EXPECT_THAT(row.allowed, HasSubstr(std::to_string(option.least)));
    EXPECT_THAT(row.allowed, HasSubstr(std::to_string(option.most)));
    EXPECT_FALSE(row.about.empty());
    return;
  }
  FAIL() << "no row";
}

TEST_P(Option, HasItsDefaultWhereNothingIsSaid) {
  EXPECT_EQ(GetParam().of(read_config({})), GetParam().standard);
}

TEST_P(Option, TakesBothEndsOfItsRange) {
  const Numeric& option = GetParam();
  for (const std::int64_t value : {option.least, option.most})
    EXPECT_EQ(option.of(read(option.name, std::to_string(value))), value);
}

TEST_P(Option, RefusesOneBeyondEitherEndNamingItAndTheRange) {
  const Numeric& option = GetParam();
  for (const std::int64_t value : {option.least - 1, option.most + 1}) {
    const std::string said = refusal(option.name, std::to_string(value));
    EXPECT_THAT(said, HasSubstr("--some-flag"));
    EXPECT_THAT(said, HasSubstr(std::to_string(value)));
    EXPECT_THAT(said, HasSubstr(std::to_string(option.least)));
    EXPECT_THAT(said, HasSubstr(std::to_string(option.most)));
  }
}

TEST_P(Option, RefusesWhatIsNoInteger) {
  for (const char* text : {"", " ", "abc", "1.5", "0x10", "1k", "true", "null", "[1]", "1e400"}) {
    const std::string said = refusal(GetParam().name, text);
    EXPECT_THAT(said, HasSubstr("--some-flag")) << text;
    EXPECT_THAT(said, HasSubstr("got " + to_json(number_from_text(text)))) << text;
  }
}

TEST_P(Option, IsTakenFromTheEnvironment) {
  const Numeric& option = GetParam();
  setenv(option.variable, std::to_string(option.most).c_str(), 1);
  EXPECT_EQ(option.of(read_config(environment_settings())), option.most);
  setenv(option.variable, "many", 1);
  std::string said;
  try {
    read_config(environment_settings());
  } catch (const std::invalid_argument& error) {
    said = error.what();
  }
  EXPECT_THAT(said, HasSubstr(option.variable));
  EXPECT_THAT(said, HasSubstr("many"));
  unsetenv(option.variable);
}

TEST_P(Option, AFlagWinsOverTheEnvironment) {
  const Numeric& option = GetParam();
  setenv(option.variable, std::to_string(option.most).c_str(), 1);
  std::vector<Setting> settings = environment_settings();
  settings.push_back({option.name, std::to_string(option.least), option.flag});
  EXPECT_EQ(option.of(read_config(settings)), option.least);
  unsetenv(option.variable);
}

std::string name_of(const testing::TestParamInfo<Numeric>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Of, Option, testing::ValuesIn(numerics), name_of);

TEST(Options, AreTheseAndNoOthers) {
  std::vector<std::string> names;
  for (const OptionRow& row : option_rows()) names.push_back(row.name);
  std::vector<std::string> tested{"host"};
  for (const Numeric& option : numerics) tested.emplace_back(option.name);
  EXPECT_THAT(names, testing::UnorderedElementsAreArray(tested));
}

TEST(Options, HostIsTextAndTheLoopbackByDefault) {
  EXPECT_EQ(read_config({}).host, "127.0.0.1");
  EXPECT_EQ(read("host", "0.0.0.0").host, "0.0.0.0");
  EXPECT_EQ(read("host", "8").host, "8");
}

TEST(Options, ProcessorsAreFrom1To64) {
  EXPECT_GE(Config::processors(), 1);
  EXPECT_LE(Config::processors(), 64);
}

}  // namespace
}  // namespace tia::test
