// Points, which take as few bytes as hold them exactly.
#include "core/accel/mesh/points.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

TEST(Points, AreWhatTheyWereWhateverHoldsThem) {
  Random random(1409);
  std::vector<double> floats, doubles;
  for (int i = 0; i < 480; ++i) {
    doubles.push_back(random.point(1e3).x);
    floats.push_back(static_cast<float>(doubles.back()));
  }
  std::vector<double> tiny = floats, huge = floats;
  tiny.front() = 0x1p-200;  // as float it would be 0
  huge.front() = 0x1p200;
  for (const auto* all : {&floats, &doubles, &tiny, &huge}) {
    const Points points(*all);
    ASSERT_EQ(points.size(), all->size() / 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(points[i].x, (*all)[3 * i]);
      EXPECT_EQ(points[i].y, (*all)[3 * i + 1]);
      EXPECT_EQ(points[i].z, (*all)[3 * i + 2]);
    }
  }
  EXPECT_EQ(heap_bytes(Points(doubles)) - heap_bytes(Points(floats)), 480 * 4);
}

TEST(Points, OneThatIsNoFloatMakesAllDouble) {
  std::vector<double> one(300, 0.5);
  const std::size_t bytes = heap_bytes(Points(one));
  one.back() = 0.1;
  EXPECT_GT(heap_bytes(Points(one)), bytes);
  EXPECT_EQ(Points(one)[99].z, 0.1);
  EXPECT_EQ(heap_bytes(Points()), 0U);
}

}  // namespace
}  // namespace tia
