#include "core/shapes/bounds.h"

#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using namespace test;

TEST(Bounds, AreABoxOrABall) {
  const auto read = [](const char* json) { return read_described<Bounds>(parse_json(json)); };
  const Region box = prepare(read(R"({"min":[-1,-2,-3],"max":[1,2,3]})"));
  EXPECT_EQ(bounds(box), (Aabb{{-1, -2, -3}, {1, 2, 3}}));
  EXPECT_EQ(elements(box), 6);
  const Region ball = prepare(read(R"({"center":[1,2,3],"radius":2})"));
  EXPECT_EQ(bounds(ball), (Aabb{{-1, 0, 1}, {3, 4, 5}}));
  EXPECT_EQ(elements(ball), 1);
}

TEST(Bounds, AreWrittenAsTheyWereRead) {
  for (const char* json :
       {R"({"max":[1,2,3],"min":[-1,-2,-3]})", R"({"center":[1,2,3],"radius":2})"})
    EXPECT_EQ(to_json(write_value(read_described<Bounds>(parse_json(json)))), json);
}

TEST(Bounds, InBothSpellingsHalfOrEmptyAreRefused) {
  constexpr auto missing = FaultKind::missing;
  const char* both = "min and max, or center and radius";
  expect_faults(faults_in<Bounds>("{}"),
                {{missing, "/min", "", both}, {missing, "/max", "", both}});
  expect_faults(faults_in<Bounds>(R"({"max":[1,1,1]})"), {{missing, "/min", "", both}});
  expect_faults(faults_in<Bounds>(R"({"min":[1,1,1]})"), {{missing, "/max", "", both}});
  expect_faults(faults_in<Bounds>(R"({"center":[1,1,1]})"), {{missing, "/radius", "", both}});
  expect_faults(faults_in<Bounds>(R"({"radius":1})"), {{missing, "/center", "", both}});
  expect_faults(faults_in<Bounds>(R"({"min":[0,0,0],"max":[1,1,1],"radius":1})"),
                {{FaultKind::conflict, "/radius", "1", both}});
  expect_faults(faults_in<Bounds>(R"({"min":[0,0,0],"center":[1,1,1]})"),
                {{FaultKind::conflict, "/center", "[1,1,1]", both}});
  expect_faults(faults_in<Bounds>(R"({"min":[0,0,0],"max":[1,0,1]})"),
                {{FaultKind::out_of_range, "/max", "[1,0,1]", "above min in every component"}});
  expect_faults(faults_in<Bounds>(R"({"center":[0,0,0],"radius":0})"),
                {{FaultKind::out_of_range, "/radius", "0", "above 0"}});
}

}  // namespace
}  // namespace tia
