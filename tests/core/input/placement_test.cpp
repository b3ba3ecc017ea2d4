#include "core/input/transform_steps.h"

#include <gtest/gtest.h>

#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using enum FaultKind;
using test::Expected;

TransformSteps read_placement(const std::string& json) {
  TransformSteps out;
  Faults faults;
  read_value(parse_json(json), Place{}.at("transform"), Spec{}, faults, out);
  faults.raise();
  return out;
}
const auto expect_placement_refused =
    test::refusal_by([](const std::string& json) { read_placement(json); });
Vec3d moved(const char* json, const Vec3d& p) { return read_placement(json).affine().point(p); }

TEST(TransformSteps, WithoutStepsIsTheIdentity) {
  EXPECT_EQ(read_placement("[]"), TransformSteps{});
  EXPECT_EQ(TransformSteps{}.affine(), Affine{});
}

TEST(TransformSteps, EachStepDoesWhatItSays) {
  EXPECT_EQ(moved(R"([{"translate":[1,2,3]}])", {10, 20, 30}), (Vec3d{11, 22, 33}));
  EXPECT_EQ(moved(R"([{"scale":2}])", {1, 2, 3}), (Vec3d{2, 4, 6}));
  EXPECT_EQ(moved(R"([{"scale":[2,-1,0.5]}])", {1, 2, 3}), (Vec3d{2, -2, 1.5}));
  // A quarter turn about z takes x to y and y to -x; about x, y to z; about y, z to x.
  EXPECT_EQ(moved(R"([{"rotate_degrees":[0,0,90]}])", {1, 2, 3}), (Vec3d{-2, 1, 3}));
  EXPECT_EQ(moved(R"([{"rotate_degrees":[90,0,0]}])", {1, 2, 3}), (Vec3d{1, -3, 2}));
  EXPECT_EQ(moved(R"([{"rotate_degrees":[0,90,0]}])", {1, 2, 3}), (Vec3d{3, 2, -1}));
  // By q = (v, w) of length 1, p becomes p + 2 v x (v x p + w p): here v = (0, 0, 0.6), w = 0.8,
  // and the length 5 of what is written changes nothing. v x p = (-1.2, 0.6, 0), so v x (v x p + w
  // p) =
  // (-0.36 - 0.96, -0.72 + 0.48, 0).
  const Vec3d turned = moved(R"([{"rotate_quaternion":[0,0,3,4]}])", {1, 2, 3});
  EXPECT_LT(length(turned - Vec3d{1 - 2 * 1.32, 2 - 2 * 0.24, 3}), 1e-15);
  // Rows times the column (1, 2, 3, 1): 1+4+9+4, 0+2+0+5, 0+0+3+6.
  EXPECT_EQ(moved(R"([{"matrix":[[1,2,3,4],[0,1,0,5],[0,0,1,6],[0,0,0,1]]}])", {1, 2, 3}),
            (Vec3d{18, 7, 9}));
}

TEST(TransformSteps, FirstStepAppliesFirst) {
  EXPECT_EQ(moved(R"([{"translate":[1,0,0]},{"scale":2}])", {1, 1, 1}), (Vec3d{4, 2, 2}));
  EXPECT_EQ(moved(R"([{"scale":2},{"translate":[1,0,0]}])", {1, 1, 1}), (Vec3d{3, 2, 2}));
  EXPECT_EQ(moved(R"([{"rotate_degrees":[90,90,0]}])", {0, 1, 0}),
            moved(R"([{"rotate_degrees":[90,0,0]},{"rotate_degrees":[0,90,0]}])", {0, 1, 0}));
}

// Each step on its own, one after the other, is what the product does at once.
TEST(TransformSteps, IsTheProductOfItsSteps) {
  test::Random random(3);
  for (int i = 0; i < 200; ++i) {
    TransformSteps placement;
    const Vec3d start = random.point(5);
    Vec3d p = start;
    for (int step = random.below(6); step > 0; --step) {
      const Vec3d v = random.vector(0.5, 2);
      switch (random.below(3)) {
        case 0: placement.steps.emplace_back(Translate{v}); break;
        case 1: placement.steps.emplace_back(RotateDegrees{v * 100.0}); break;
        default: placement.steps.emplace_back(Scale{v});
      }
      p = std::visit([](const auto& is) { return is.affine(); }, placement.steps.back()).point(p);
    }
    EXPECT_LT(length(placement.affine().point(start) - p), 1e-12 * (1 + length(p)) * 100);
  }
}

TEST(TransformSteps, IsWrittenAsItWasGiven) {
  for (const char* text :
       {R"([{"translate":[1,2,3]},{"scale":2},{"scale":[2,2,2]},{"rotate_degrees":[0,0,450]}])",
        R"([{"rotate_quaternion":[0,0,3,4]}])",
        R"([{"matrix":[[1,2,3,4],[0,1,0,5],[0,0,1,6],[0,0,0,1]]}])", "[]"})
    EXPECT_EQ(to_json(write_value(read_placement(text))), text);
  EXPECT_NE(read_placement(R"([{"scale":2}])"), read_placement(R"([{"scale":[2,2,2]}])"));
}

TEST(TransformSteps, AQuaternionHasFourNumbersAndALength) {
  expect_placement_refused(
      R"([{"rotate_quaternion":[0,0,0,0]}])",
      {{out_of_range, "/transform/0/rotate_quaternion", "[0,0,0,0]", "numbers that"}});
  expect_placement_refused(
      R"([{"rotate_quaternion":[0,0,1]}])",
      {{wrong_type, "/transform/0/rotate_quaternion", "[0,0,1]", "4 numbers"}});
}

TEST(TransformSteps, StepsHaveExactlyOneKnownKey) {
  const char* keys = "one of translate, rotate_degrees, scale, matrix, rotate_quaternion";
  expect_placement_refused("[{}]", {{missing, "/transform/0", "", keys}});
  expect_placement_refused(
      R"([{"scale":2},{"rotate":[0,0,90]}])",
      {{unknown_name, "/transform/1/rotate", "\"rotate\"", keys, "rotate_degrees"}});
  expect_placement_refused(R"([{"trnslate":[0,0,90]}])", {{unknown_name, "/transform/0/trnslate",
                                                           "\"trnslate\"", keys, "translate"}});
  expect_placement_refused(
      R"([{"scale":2,"translate":[1,2,3]}])",
      {{conflict, "/transform/0", R"({"scale":2,"translate":[1,2,3]})", "one key"}});
  expect_placement_refused("[5]",
                           {{wrong_type, "/transform/0", "5", "an object with one key, one of"}});
  expect_placement_refused("{}", {{wrong_type, "/transform", "{}", "an array"}});
}

TEST(TransformSteps, NumbersOfAStepAreRefusedAtTheirPlaces) {
  expect_placement_refused(
      R"([{"scale":0},{"scale":[1,0,2]},{"translate":[1,2]},{"scale":"x"}])",
      {{out_of_range, "/transform/0/scale", "0", "to 1000000000, not 0"},
       {out_of_range, "/transform/1/scale/1", "0", "not 0"},
       {wrong_type, "/transform/2/translate", "[1,2]", "3 numbers, each a number from"},
       {wrong_type, "/transform/3/scale", "\"x\"", "or one number for all 3"}});
  expect_placement_refused(
      R"([{"rotate_degrees":[0,0,1e7]},{"translate":[2e9,0,0]}])",
      {{out_of_range, "/transform/0/rotate_degrees/2", "10000000", "(degrees)"},
       {out_of_range, "/transform/1/translate/0", "2000000000", "to 1000000000"}});
}

TEST(TransformSteps, MatricesHaveFourRowsOfFourAndTheLastIsFixed) {
  const auto matrix = [](const char* rows) {
    return std::string(R"([{"matrix":[)").append(rows).append("]}]");
  };
  expect_placement_refused(matrix("[1,0,0,0],[0,1,0,0],[0,0,1,0]"),
                           {{wrong_type, "/transform/0/matrix", "[[1,0,0,0],[0,1,0,0],[0,0,1,0]]",
                             "4 lists, each 4 numbers, each a number"}});
  expect_placement_refused(matrix("[1,0,0,0],[0,1,0],[0,0,1,0],[0,0,0,1]"),
                           {{wrong_type, "/transform/0/matrix/1", "[0,1,0]", "4 numbers"}});
  expect_placement_refused(matrix("[1,0,0,0],[0,null,0,0],[0,0,1,0],[0,0,0,1]"),
                           {{wrong_type, "/transform/0/matrix/1/1", "null", "a number"}});
  expect_placement_refused(matrix("[1,0,0,0],[0,1,0,0],[0,0,1,0],[0,0,0.5,1]"),
                           {{out_of_range, "/transform/0/matrix/3", "[0,0,0.5,1]", "[0,0,0,1]"}});
}

TEST(TransformSteps, MapsThatCannotBeUndoneAreRefused) {
  const auto matrix = [](const char* rows) {
    return std::string(R"([{"matrix":[)").append(rows).append(",[0,0,0,1]]}]");
  };
  // A zero column; three columns in a plane, by the classic singular matrix 1 .. 9.
  expect_placement_refused(matrix("[1,0,0,0],[0,1,0,0],[0,0,0,0]"),
                           {{out_of_range, "/transform/0/matrix",
                             "[[1,0,0,0],[0,1,0,0],[0,0,0,0],[0,0,0,1]]", "can be undone"}});
  expect_placement_refused(matrix("[1,2,3,0],[4,5,6,0],[7,8,9,0]"),
                           {{out_of_range, "/transform/0/matrix",
                             "[[1,2,3,0],[4,5,6,0],[7,8,9,0],[0,0,0,1]]", "can be undone"}});
  EXPECT_NO_THROW(read_placement(matrix("[1,2,3,0],[4,5,6,0],[7,8,10,0]")));
  EXPECT_NO_THROW(read_placement(matrix("[1e-9,0,0,0],[0,1e9,0,0],[0,0,-1,0]")));
  expect_placement_refused(R"([{"scale":1},{"scale":1e-10}])",
                           {{out_of_range, "/transform/1/scale", "1e-10", "by 1e-9 to 1e9"}});
}

TEST(TransformSteps, StepsMayNotScaleTooFarTogether) {
  EXPECT_NO_THROW(read_placement(R"([{"scale":1e6},{"scale":1e3}])"));
  EXPECT_NO_THROW(read_placement(R"([{"scale":1e9},{"scale":1e-9},{"scale":1e9}])"));
  expect_placement_refused(R"([{"scale":1e6},{"scale":1e4}])",
                           {{out_of_range, "/transform", R"([{"scale":1000000},{"scale":10000}])",
                             "steps that together scale every axis by 1e-9 to 1e9"}});
  std::string many = "[";
  for (int i = 0; i < 400; ++i) many += R"({"translate":[1e9,0,0]},{"scale":1e9},)";
  EXPECT_EQ(test::faults_of([&] { read_placement(many + R"({"scale":1}])"); }).size(), 1U)
      << "infinite";
}

}  // namespace
}  // namespace tia
