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

// Lines through a face's plane, along an axis, beside it and with NaN among them.
TEST(Bounds, OfEightLinesHoldWhatTheyHoldOfEach) {
  Random random(78);
  const Region regions[] = {Region{Box{{-1, -2, 0.5}, {1, 0, 3}}}, Region{Sphere{{1, 2, 3}, 2}}};
  int held = 0, missed = 0;
  for (int round = 0; round < 2000; ++round) {
    std::array<std::array<double, 8>, 6> parts;
    std::array<Line, 8> lines;
    for (std::size_t i = 0; i < 8; ++i) {
      Line& line = lines[i];
      line = {random.vector(0, 5), normalize(random.vector(0.1, 1))};
      if (random.chance(0.2)) line.direction = {0, random.chance(0.5) ? 1.0 : -1.0, 0};
      if (random.chance(0.2)) line.origin.x = random.chance(0.5) ? -1 : 1;
      if (random.chance(0.02)) line.origin.y = std::numeric_limits<double>::quiet_NaN();
      const double all[] = {line.origin.x,    line.origin.y,    line.origin.z,
                            line.direction.x, line.direction.y, line.direction.z};
      for (std::size_t k = 0; k < 6; ++k) parts[k][i] = all[k];
    }
    const auto of = [&](std::size_t k) { return Octet::load_unaligned(parts[k].data()); };
    for (const Region& region : regions) {
      const EightChords eight = chords(region, {{of(0), of(1), of(2)}, {of(3), of(4), of(5)}});
      for (int i = 0; i < 8; ++i) {
        const Chord one = chord(region, lines[static_cast<std::size_t>(i)]);
        const double in = lane(eight.in, i), out = lane(eight.out, i);
        EXPECT_EQ(one.empty(), !(in <= out));
        (one.empty() ? missed : held) += 1;
        if (one.empty()) continue;
        EXPECT_EQ(in, one.in.t);
        EXPECT_EQ(out, one.out.t);
      }
    }
  }
  EXPECT_GT(held, 5000);
  EXPECT_GT(missed, 5000);
}

}  // namespace
}  // namespace tia
