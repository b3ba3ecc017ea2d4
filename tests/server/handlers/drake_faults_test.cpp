// POST /render of forms that Drake's client would not send, or whose scenes cannot be seen.
#include <algorithm>

#include "server/stores/digest.h"
#include "tests/server/drake_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

struct Refusal {
  const char* law;
  std::string name, text;  // the field and what it says; "-": it is left out
  const char *type, *pointer;
};

class RefusedForms : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedForms, NameTheField) {
  const auto& [law, name, text, type, pointer] = GetParam();
  DrakeFields fields = drake_fields("depth");
  const std::string& left_out = GetParam().name;
  if (text == "-")
    std::erase_if(fields, [&](const auto& field) { return field.first == left_out; });
  else set_field(fields, name, text);
  const Response response = send_drake(fields, plain_scene());
  EXPECT_EQ(response.status, std::string(type) == "malformed" ? 400 : 422);
  const Problem problem = problem_of(response);
  EXPECT_THAT(problem.type, HasSubstr(type)) << response.body;
  ASSERT_FALSE(problem.errors.empty());
  EXPECT_EQ(problem.errors.front().pointer, pointer);
}

const std::string other_hash(64, 'a');
const Refusal refusals[] = {
    {"UnknownField", "focal_z", "1", "unknown-name", "/focal_z"},
    {"MissingWidth", "width", "-", "missing", "/width"},
    {"MissingFocalLength", "focal_x", "-", "missing", "/focal_x"},
    {"MissingImageType", "image_type", "-", "missing", "/image_type"},
    {"MissingMinDepth", "min_depth", "-", "missing", "/min_depth"},
    {"MissingMaxDepth", "max_depth", "-", "missing", "/max_depth"},
    {"DepthsOfLabels", "image_type", "label", "conflict", "/min_depth"},
    {"UnknownImageType", "image_type", "heat", "unknown-name", "/image_type"},
    {"TextForANumber", "near", "close", "wrong-type", "/near"},
    {"FocalLengthOfNothing", "focal_y", "0", "out-of-range", "/focal_y"},
    {"FarBeforeNear", "far", "0.005", "out-of-range", "/far"},
    {"DepthsTheWrongWayRound", "max_depth", "1", "out-of-range", "/max_depth"},
    {"FocalLengthOfNextToNothing", "focal_x", "1e-9", "out-of-range", "/focal_x"},
    {"AnotherHash", "scene_sha256", other_hash, "conflict", "/scene_sha256"},
    {"NoUtf8", "submit", "\xff", "malformed", "/submit"},
};
INSTANTIATE_TEST_SUITE_P(All, RefusedForms, testing::ValuesIn(refusals), law_of);

TEST(Drake, HashesThatFitAndWhatIsNoneArePassed) {
  DrakeFields fields = drake_fields("label");
  std::string hash = sha256_hex(plain_scene());
  for (const std::string& text : {hash, std::string("None"), std::string(64, 'x')}) {
    set_field(fields, "scene_sha256", text);
    EXPECT_EQ(send_drake(fields, plain_scene()).status, 200) << text;
  }
  std::ranges::transform(hash, hash.begin(),
                         [](char c) { return c >= 'a' && c <= 'f' ? char(c - 'a' + 'A') : c; });
  set_field(fields, "scene_sha256", hash);
  EXPECT_EQ(send_drake(fields, plain_scene()).status, 200);
}

TEST(Drake, ScenesThatCannotBeSeenAreRefusedAtScene) {
  const auto refused = [](const std::string& scene) {
    return problem_of(send_drake(drake_fields("label"), scene));
  };
  EXPECT_EQ(refused("").errors.front().pointer, "/scene");
  EXPECT_THAT(refused("no model").type, HasSubstr("media-type"));
  std::string text = plain_scene();
  text.replace(text.find("\"camera\":0,"), 11, "");
  EXPECT_EQ(refused(text).errors.front().pointer, "/scene");
  text = plain_scene();
  text.replace(text.find("\"POSITION\":0"), 12, "\"POSITION\":7");
  EXPECT_THAT(refused(text).errors.front().pointer, testing::StartsWith("/scene/meshes/0"));
  // A camera that its nodes together take farther away than any scene reaches.
  DrakeSensor remote;
  remote.location = {0, 9e8, 0};
  text = drake_scene({{{-1, -9e8, -3}, {1, -9e8, -3}, {0, -9e8, -4}, 1, 2, 3}}, remote);
  const std::string list_end = "],\"scene\":0";
  text.replace(text.find(list_end), 1, ",{\"children\":[1],\"translation\":[0,9e8,0]}]");
  text.replace(text.find("\"nodes\":[0,1]"), 13, "\"nodes\":[0,2]");
  EXPECT_EQ(refused(text).errors.front().pointer, "/scene");
}

TEST(Drake, QueriesSayWhatFormsDoNot) {
  const auto refused = [](const std::string& query, const std::string& image_type) {
    return only_error(send_drake(drake_fields(image_type), plain_scene(), query)).pointer;
  };
  EXPECT_EQ(refused("?width=5", "color"), "/width");
  EXPECT_EQ(refused("?format=pfm", "color"), "/format");
  EXPECT_EQ(refused("?integrator=normal", "color"), "/integrator");
  EXPECT_EQ(refused("?integrator=path", "label"), "/integrator");
  EXPECT_EQ(refused("?threads=0", "label"), "/threads");
  EXPECT_EQ(send_drake(drake_fields("label"), plain_scene(), "?threads=1").status, 200);
  const std::string form = drake_form(drake_fields("label"), plain_scene());
  EXPECT_EQ(
      host()
          .ask("POST", "/render", form, {{"Content-Type", drake_type()}, {"Accept", "image/tiff"}})
          .status,
      406);
}

// Drake's client shows no problem of 8192 bytes or more.
TEST(Drake, ProblemsAreShort) {
  DrakeFields fields = drake_fields("depth");
  for (int i = 0; i < 40; ++i)
    fields.emplace_back(std::string(200, 'n') + std::to_string(i), std::string(500, '"'));
  const Response response = send_drake(fields, plain_scene());
  EXPECT_EQ(response.status, 422);
  EXPECT_LT(response.body.size(), 8192U);
  EXPECT_GT(response.body.size(), 5000U);
  fields = drake_fields("depth");
  fields.emplace_back("width", "64");
  EXPECT_EQ(only_error(send_drake(fields, plain_scene())).pointer, "/width") << "each once";
}

}  // namespace
}  // namespace tia::test
