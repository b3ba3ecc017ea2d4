// The options' table: names, defaults, ranges at both ends, and who wins.
#include "server/operation/config.h"

#include <cstdlib>
#include <sstream>

#include "server/contract/text_form.h"
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
    {"renders", "--renders", "TIA_RENDERS", 8, 1, 64,
     [](const Config& c) -> std::int64_t { return c.renders; }},
    {"queue", "--queue", "TIA_QUEUE", 64, 0, 1024,
     [](const Config& c) -> std::int64_t { return c.queue; }},
    {"connections", "--connections", "TIA_CONNECTIONS", 1024, 8, 65536,
     [](const Config& c) -> std::int64_t { return c.connections; }},
    {"memory_bytes", "--memory-bytes", "TIA_MEMORY_BYTES", usual_memory_bytes(), 268'435'456,
     1'125'899'906'842'624, [](const Config& c) { return c.memory_bytes; }},
    {"deadline_ms", "--deadline-ms", "TIA_DEADLINE_MS", 30'000, 1, 3'600'000,
     [](const Config& c) -> std::int64_t { return c.deadline_ms; }},
    {"drain_ms", "--drain-ms", "TIA_DRAIN_MS", 9'000, 0, 600'000,
     [](const Config& c) -> std::int64_t { return c.drain_ms; }},
    {"drain_delay_ms", "--drain-delay-ms", "TIA_DRAIN_DELAY_MS", 0, 0, 600'000,
     [](const Config& c) -> std::int64_t { return c.drain_delay_ms; }},
    {"max_nodes", "--max-nodes", "TIA_MAX_NODES", 100'000, 4096, 1'000'000'000,
     [](const Config& c) -> std::int64_t { return c.max_nodes; }},
    {"max_body_bytes", "--max-body-bytes", "TIA_MAX_BODY_BYTES", 4'194'304, 1024, 1'073'741'824,
     [](const Config& c) { return c.max_body_bytes; }},
    {"max_png_bytes", "--max-png-bytes", "TIA_MAX_PNG_BYTES", 67'108'864, 1024, 1'073'741'824,
     [](const Config& c) { return c.max_png_bytes; }},
    {"cache_bytes", "--cache-bytes", "TIA_CACHE_BYTES", 268'435'456, 0, 1'099'511'627'776,
     [](const Config& c) { return c.cache_bytes; }},
    {"scene_keep_s", "--scene-keep-s", "TIA_SCENE_KEEP_S", 0, 0, 1'000'000'000,
     [](const Config& c) { return c.scene_keep_s; }},
    {"max_data_bytes", "--max-data-bytes", "TIA_MAX_DATA_BYTES", 1'073'741'824, 1'048'576,
     1'099'511'627'776, [](const Config& c) { return c.max_data_bytes; }},
    {"max_scenes_bytes", "--max-scenes-bytes", "TIA_MAX_SCENES_BYTES", 67'108'864, 0,
     1'099'511'627'776, [](const Config& c) { return c.max_scenes_bytes; }},
    {"max_geometry_bytes", "--max-geometry-bytes", "TIA_MAX_GEOMETRY_BYTES", 268'435'456, 0,
     1'099'511'627'776, [](const Config& c) { return c.max_geometry_bytes; }},
    {"max_model_bytes", "--max-model-bytes", "TIA_MAX_MODEL_BYTES", 67'108'864, 1024, 1'073'741'824,
     [](const Config& c) { return c.max_model_bytes; }},
    {"max_models_bytes", "--max-models-bytes", "TIA_MAX_MODELS_BYTES", 268'435'456, 0,
     1'099'511'627'776, [](const Config& c) { return c.max_models_bytes; }},
    {"max_triangles", "--max-triangles", "TIA_MAX_TRIANGLES", 8'388'608, 1, 268'435'456,
     [](const Config& c) { return c.max_triangles; }},
    {"max_texture_pixels", "--max-texture-pixels", "TIA_MAX_TEXTURE_PIXELS", 100'663'296, 1,
     4'294'967'296, [](const Config& c) { return c.max_texture_pixels; }},
    {"model_memory_bytes", "--model-memory-bytes", "TIA_MODEL_MEMORY_BYTES", 2'147'483'648,
     134'217'728, 1'099'511'627'776, [](const Config& c) { return c.model_memory_bytes; }},
    {"max_rays", "--max-rays", "TIA_MAX_RAYS", 2'000'000'000, 1, 1'000'000'000'000'000,
     [](const Config& c) { return c.max_rays; }},
    {"max_work", "--max-work", "TIA_MAX_WORK", 10'000'000'000, 1, 1'000'000'000'000'000,
     [](const Config& c) { return c.max_work; }},
    {"max_events", "--max-events", "TIA_MAX_EVENTS", 1'000'000, 1, 1'000'000'000,
     [](const Config& c) { return c.max_events; }},
    {"max_frames", "--max-frames", "TIA_MAX_FRAMES", 3600, 1, 100'000,
     [](const Config& c) -> std::int64_t { return c.max_frames; }},
    {"film_deadline_ms", "--film-deadline-ms", "TIA_FILM_DEADLINE_MS", 600'000, 1, 86'400'000,
     [](const Config& c) -> std::int64_t { return c.film_deadline_ms; }},
    {"streams", "--streams", "TIA_STREAMS", 32, 0, 1024,
     [](const Config& c) -> std::int64_t { return c.streams; }},
    {"max_job_rays", "--max-job-rays", "TIA_MAX_JOB_RAYS", 1'000'000'000'000, 1,
     1'000'000'000'000'000, [](const Config& c) { return c.max_job_rays; }},
    {"max_jobs", "--max-jobs", "TIA_MAX_JOBS", 1000, 0, 100'000,
     [](const Config& c) -> std::int64_t { return c.max_jobs; }},
    {"max_jobs_bytes", "--max-jobs-bytes", "TIA_MAX_JOBS_BYTES", 1'073'741'824, 1'048'576,
     1'099'511'627'776, [](const Config& c) { return c.max_jobs_bytes; }},
    {"job_keep_s", "--job-keep-s", "TIA_JOB_KEEP_S", 86'400, 1, 1'000'000'000,
     [](const Config& c) { return c.job_keep_s; }},
    {"job_tries", "--job-tries", "TIA_JOB_TRIES", 5, 1, 1000,
     [](const Config& c) -> std::int64_t { return c.job_tries; }},
    {"farm_lease_ms", "--farm-lease-ms", "TIA_FARM_LEASE_MS", 15'000, 100, 3'600'000,
     [](const Config& c) -> std::int64_t { return c.farm_lease_ms; }},
    {"max_pixels", "--max-pixels", "TIA_MAX_PIXELS", 16'777'216, 1, 268'435'456,
     [](const Config& c) { return c.max_pixels; }},
};

Config config_of(const std::string& name, const std::string& text) {
  return read_config({{name, text, "--some-flag"}});
}
// What read_config says against the text; "" where it takes it.
std::string refusal(const std::string& name, const std::string& text) {
  try {
    config_of(name, text);
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
    EXPECT_EQ(row.value, std::to_string(option.standard));
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
    EXPECT_EQ(option.of(config_of(option.name, std::to_string(value))), value);
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

std::string option_name(const testing::TestParamInfo<Numeric>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Of, Option, testing::ValuesIn(numerics), option_name);

TEST(Options, AreTheseAndNoOthers) {
  std::vector<std::string> names;
  for (const OptionRow& row : option_rows()) names.push_back(row.name);
  std::vector<std::string> tested{"host",         "data_dir",
                                  "cors_origins", "trusted_proxies",
                                  "hosts",        "ffmpeg",
                                  "keys_file",    "sign_file",
                                  "farm",         "farm_password_file",
                                  "farm_ca_file", "farm_audit",
                                  "store",        "s3_endpoint",
                                  "s3_region",    "s3_key_file"};
  for (const Numeric& option : numerics) tested.emplace_back(option.name);
  EXPECT_THAT(names, testing::UnorderedElementsAreArray(tested));
}

TEST(Options, HostIsTextAndTheLoopbackByDefault) {
  EXPECT_EQ(read_config({}).host, "127.0.0.1");
  EXPECT_EQ(config_of("host", "0.0.0.0").host, "0.0.0.0");
  EXPECT_EQ(config_of("host", "8").host, "8");
}

TEST(Options, AreReadBackFromTheFileOfVariablesThatTheyPrint) {
  const Config config = read_config({{"host", "::1", ""},
                                     {"max_rays", "123456789012345", ""},
                                     {"cors_origins", "https://a.example, http://b:81", ""},
                                     {"trusted_proxies", "10.0.0.0/8,::1", ""}});
  std::istringstream lines(env_file(config));
  std::vector<Setting> settings;
  for (std::string comment, line; std::getline(lines, comment) && std::getline(lines, line);) {
    ASSERT_LT(settings.size(), option_rows().size());
    const OptionRow row = option_rows()[settings.size()];
    EXPECT_EQ(comment, "# " + row.about + ": " + row.allowed);
    ASSERT_TRUE(line.starts_with(row.variable + "=")) << line;
    settings.push_back({row.name, line.substr(row.variable.size() + 1), row.variable});
  }
  EXPECT_EQ(settings.size(), option_rows().size());
  EXPECT_EQ(env_file(read_config(settings)), env_file(config));
}

TEST(Options, AListHasCommasAndMayBeEmpty) {
  EXPECT_TRUE(config_of("cors_origins", "").cors_origins.empty());
  EXPECT_TRUE(config_of("trusted_proxies", " ").trusted_proxies.empty());
  const auto origins = config_of("cors_origins", "https://a.example , *").cors_origins;
  ASSERT_EQ(origins.size(), 2U);
  EXPECT_EQ(origins[0].text, "https://a.example");
  EXPECT_TRUE(origins[1].is_any());
}

TEST(Options, ABadEntryOfAListIsNamed) {
  const std::pair<const char*, const char*> lists[] = {
      {"trusted_proxies", "10.0.0.0/8,10.0.0.0/33"}, {"cors_origins", "*,http:/a"}};
  for (const auto& [name, list] : lists) {
    const std::string text = list, entry = text.substr(text.find(',') + 1);
    EXPECT_THAT(refusal(name, text), HasSubstr("--some-flag: got \"" + entry + "\", allowed: "));
    EXPECT_THAT(refusal(name, "*,"), HasSubstr("--some-flag: got \""));
  }
}

TEST(Options, APortThatKubernetesSetIsRefusedWithTheWayOut) {
  EXPECT_THAT(refusal("port", "tcp://10.0.0.1:8080"),
              testing::AllOf(HasSubstr("tcp://10.0.0.1:8080"), HasSubstr("65535"),
                             HasSubstr("enableServiceLinks: false")));
  EXPECT_THAT(refusal("port", "http"), Not(HasSubstr("Kubernetes")));
}

TEST(Options, AVariableThatIsNoOptionIsNamedWithTheNearestOne) {
  EXPECT_THAT(unknown_variables(), testing::IsEmpty());
  setenv("TIA_MAX_PIXEL", "1", 1);
  setenv("TIA_SERVICE_HOST", "1", 1);
  const std::string nearest = "TIA_MAX_PIXEL is no option, did you mean TIA_MAX_PIXELS?";
  EXPECT_THAT(unknown_variables(),
              testing::UnorderedElementsAre(nearest, "TIA_SERVICE_HOST is no option"));
  unsetenv("TIA_MAX_PIXEL");
  unsetenv("TIA_SERVICE_HOST");
}

TEST(Options, ProcessorsAreFrom1To64) {
  EXPECT_GE(Config::processors(), 1);
  EXPECT_LE(Config::processors(), 64);
}

}  // namespace
}  // namespace tia::test
