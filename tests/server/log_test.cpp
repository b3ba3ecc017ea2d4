// What the server tells its log and not its clients.
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// A triangle, and two more without area: two corners at one place, and three on one line.
constexpr const char* flat_mesh = R"({"objects":[{"type":"mesh",
    "positions":[-1,-1,-5, 1,-1,-5, 0,1,-5, 0,0,-5],"indices":[0,1,2, 0,0,1, 2,3,3]}]})";
constexpr const char* said = "2 triangles without area are ignored";

TEST(Log, CountsTheTrianglesWithoutAreaThatARequestLeavesOut) {
  Host host;
  const std::string asked = R"({"width":8,"height":8,"scene":)" + std::string(flat_mesh) + "}";
  testing::internal::CaptureStderr();
  const Response response = host.post("/render", asked);
  const std::string log = testing::internal::GetCapturedStderr();
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(log, std::string("request ") + Host::id + ": " + said + "\n");
  for (const auto& [name, value] : response.headers) EXPECT_THAT(value, Not(HasSubstr("area")));
}

TEST(Log, SaysNothingOfAMeshWhoseTrianglesAllHaveArea) {
  Host host;
  testing::internal::CaptureStderr();
  host.post("/render", R"({"width":8,"height":8,"scene":{"objects":[{"type":"mesh",
      "positions":[-1,-1,-5, 1,-1,-5, 0,1,-5],"indices":[0,1,2]}]}})");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Log, TiaRenderSaysItOnItsErrorOutput) {
  const Folder folder;
  std::ofstream(folder.file("flat.json")) << flat_mesh;
  const Finished end = run({"render", folder.file("flat.json"), "-o", folder.file("flat.png")});
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(end.err, std::string("tia: ") + said + "\n");
}

}  // namespace
}  // namespace tia::test
