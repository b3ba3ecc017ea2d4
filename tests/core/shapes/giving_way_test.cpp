// Surfaces that take long to make let others go first meanwhile, and end where nobody wants them.
#include <gtest/gtest.h>

#include "core/parallel/stopped.h"
#include "core/shapes/formula/implicit.h"
#include "core/shapes/parametric/parametric.h"

namespace tia {
namespace {

/// Counts how often work that is done here would let others go first; stops it at `last`.
struct Counter : Courtesy {
  explicit Counter(int at) : last(at) { courtesy = this; }
  ~Counter() override { courtesy = nullptr; }
  void let_others_go() override {
    if (++count == last) throw Stopped();
  }
  int count = 0;
  const int last;
};

template <class Shape>
void expect_courtesy(const Shape& shape, std::size_t least) {
  Counter counter(-1);
  prepare(shape);
  EXPECT_GE(static_cast<std::size_t>(counter.count), least);
  Counter impatient(100);
  EXPECT_THROW(prepare(shape), Stopped);
}

TEST(GivingWay, OfAnImplicitSurfaceAtEachNodeOfItsTree) {
  const Implicit waves{"sin(9*x)*sin(8*y)*sin(7*z)", {{}, {}, Vec3d{}, 2}, {}};
  expect_courtesy(waves, prepare(waves).cells->tree.nodes.size());
}

TEST(GivingWay, OfAParametricSurfaceAtEachNodeOfItsTree) {
  const Parametric sheet{"u", "v", "sin(40*u*v)", {-3, 3}, {-3, 3}, {}};
  expect_courtesy(sheet, prepare(sheet).patches->tree.nodes.size());
}

}  // namespace
}  // namespace tia
