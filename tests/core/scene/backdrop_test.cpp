// What may stand for a backdrop in JSON.
#include "core/scene/backdrop.h"

#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

TEST(BackdropText, IsAColourOrTransparent) {
  EXPECT_EQ(read_scene("{}").backdrop, std::nullopt);
  EXPECT_EQ(read_scene(R"({"backdrop":"transparent"})").backdrop, Backdrop{});
  EXPECT_EQ(read_scene(R"({"backdrop":0.5})").backdrop, (Backdrop{Color{0.5, 0.5, 0.5}}));
  EXPECT_EQ(read_scene(R"({"backdrop":[0.1,2,3]})").backdrop, (Backdrop{Color{0.1, 2, 3}}));
}

TEST(BackdropText, IsWrittenAsItIsRead) {
  for (const std::string json :
       {R"({"backdrop":"transparent"})", R"({"backdrop":[0,0,0]})", R"({"backdrop":[0.5,1,2]})"})
    EXPECT_EQ(canonical_text(read_scene(json)), json);
}

TEST(BackdropText, RefusesWhatIsNeither) {
  const auto fault_of = [](const std::string& json) {
    try {
      read_scene(json);
    } catch (const InputError& error) {
      return error.faults().front();
    }
    return Fault{};
  };
  const Fault word = fault_of(R"({"backdrop":"transparant"})");
  EXPECT_EQ(word.pointer, "/backdrop");
  EXPECT_EQ(word.nearest, "transparent");
  const Fault type = fault_of(R"({"backdrop":{}})");
  EXPECT_EQ(type.kind, FaultKind::wrong_type);
  EXPECT_NE(type.allowed.find("or \"transparent\""), std::string::npos);
  EXPECT_EQ(fault_of(R"({"backdrop":[0,-1,0]})").pointer, "/backdrop/1");
  EXPECT_EQ(fault_of(R"({"backdrop":[0,0]})").pointer, "/backdrop");
}

}  // namespace
}  // namespace tia
