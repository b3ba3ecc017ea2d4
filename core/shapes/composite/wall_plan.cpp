#include "core/shapes/composite/wall_plan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "core/input/codec.h"
#include "core/input/json.h"

namespace tia {
namespace {

using PlanVector = Walls::Point;

constexpr double rounding = 1e-12;  // of sines, cosines, and shares of a length

double dot(const PlanVector& a, const PlanVector& b) { return a[0] * b[0] + a[1] * b[1]; }
double turn(const PlanVector& a, const PlanVector& b) { return a[0] * b[1] - a[1] * b[0]; }

WallRun run_between(const PlanVector& a, const PlanVector& b, double begin) {
  const PlanVector by{b[0] - a[0], b[1] - a[1]};
  const double length = std::sqrt(dot(by, by));
  return {a, {by[0] / length, by[1] / length}, length, begin, 0, length, 0, length};
}

/// PlanPiece: a run's rectangle or a corner's kite. Its `order` along the line: run k is 2 k, the
/// corner after it 2 k + 1.
struct PlanPiece {
  std::array<PlanVector, 4> outline;
  std::size_t order = 0;
};

// How far the four points reach along a direction.
std::pair<double, double> reach_along(const PlanVector& way, const PlanPiece& piece) {
  const auto& p = piece.outline;
  return std::minmax({dot(p[0], way), dot(p[1], way), dot(p[2], way), dot(p[3], way)});
}

// Whether a line along a side of `of` is between both (the separating axis theorem).
bool parted_by_sides(const PlanPiece& of, const PlanPiece& other, double same) {
  for (std::size_t k = 0; k < 4; ++k) {
    const PlanVector &a = of.outline[k], &b = of.outline[(k + 1) % 4];
    const PlanVector normal{a[1] - b[1], b[0] - a[0]};
    const double length = std::sqrt(dot(normal, normal));
    if (length == 0) continue;
    const auto [low, high] = reach_along({normal[0] / length, normal[1] / length}, of);
    const auto [from, to] = reach_along({normal[0] / length, normal[1] / length}, other);
    if (high <= from + same || to <= low + same) return true;
  }
  return false;
}

bool overlap(const PlanPiece& a, const PlanPiece& b, double same) {
  return !parted_by_sides(a, b, same) && !parted_by_sides(b, a, same);
}

/// PlanMaking: the plan, and what is wrong with its points.
class PlanMaking {
 public:
  PlanMaking(const Walls& walls, const Place& at, Faults& faults)
      : walls_(walls), points_(at), faults_(faults), half_(walls.thickness / 2) {}

  WallPlan operator()() {
    if (!points_fit()) return {};
    add_runs();
    for (std::size_t i = 0; i < plan_.runs.size(); ++i) add_corner(i);
    const std::size_t before = faults_.count();
    for (std::size_t i = 0; i < plan_.runs.size(); ++i) check_room(i);
    if (faults_.count() == before) check_apart();
    return std::move(plan_);
  }

 private:
  void refuse(std::size_t point, FaultKind kind, const std::string& allowed) {
    const std::size_t i = point % walls_.points.size();
    faults_.add({kind, points_.at(i).pointer(), write_value(walls_.points[i]), allowed});
  }

  bool points_fit() {
    const std::vector<PlanVector>& all = walls_.points;
    const std::size_t before = faults_.count();
    if (all.size() > Walls::most_points)
      faults_.add({FaultKind::limit, points_.pointer(), Value(double(all.size())),
                   "at most " + std::to_string(Walls::most_points) + " points"});
    else if (walls_.closed && all.size() < 3)
      faults_.add({FaultKind::conflict, points_.pointer(), Value(double(all.size())),
                   "at least 3 points, where the walls are closed"});
    else if (walls_.closed && all.front() == all.back())
      refuse(all.size() - 1, FaultKind::conflict,
             "another point than the first: closed walls go back there by themselves");
    if (faults_.count() != before) return false;
    for (std::size_t i = 1; i < all.size(); ++i)
      if (all[i] == all[i - 1])
        refuse(i, FaultKind::conflict, "another point than the one before it");
    return faults_.count() == before;
  }

  void add_runs() {
    const std::vector<PlanVector>& all = walls_.points;
    const std::size_t runs = walls_.closed ? all.size() : all.size() - 1;
    double begin = 0;
    for (std::size_t i = 0; i < runs; ++i) {
      plan_.runs.push_back(run_between(all[i], all[(i + 1) % all.size()], begin));
      begin += plan_.runs.back().length;
    }
    plan_.corners.resize(runs);
  }

  // Between run i and the one after it.
  void add_corner(std::size_t i) {
    if (i + 1 == plan_.runs.size() && !walls_.closed) return;
    WallRun &a = plan_.runs[i], &b = plan_.runs[next(i)];
    const double sine = turn(a.way, b.way), cosine = dot(a.way, b.way);
    if (std::fabs(sine) <= rounding && cosine > 0) return;
    const bool is_right = std::fabs(cosine) <= rounding;
    const double reach = is_right         ? half_
                         : 1 + cosine > 0 ? half_ * std::fabs(sine) / (1 + cosine)
                                          : std::numeric_limits<double>::infinity();
    a.high = a.length - reach;
    b.low = b.from = reach;
    a.to = is_right ? a.length + half_ : a.high;
    if (!is_right) plan_.corners[i] = kite(a, b, reach, sine > 0);
  }
  WallCorner kite(const WallRun& a, const WallRun& b, double reach, bool to_z) const {
    const double inner = to_z ? half_ : -half_;
    WallCorner points{a.at(a.length - reach, inner), a.at(a.length - reach, -inner),
                      a.at(a.length + reach, -inner), b.at(reach, -inner)};
    if (to_z) std::ranges::reverse(points);
    return points;
  }

  void check_room(std::size_t i) {
    const WallRun& run = plan_.runs[i];
    const double need = run.low + (run.length - run.high);
    if (need <= run.length * (1 + rounding)) return;
    refuse(i + 1, FaultKind::conflict,
           std::isfinite(need)
               ? "at least " + number_text(need) + " from the point before, for its corners"
               : "a corner that does not turn back");
  }

  // Of pieces of the plan that do not meet at a corner.
  void check_apart() {
    const std::vector<PlanPiece> pieces = pieces_along();
    const double same = tolerance();
    for (std::size_t j = 0; j < pieces.size() && !faults_.full(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        if (meet(pieces[i].order, pieces[j].order) || !overlap(pieces[i], pieces[j], same))
          continue;
        refuse(pieces[j].order / 2 + 1, FaultKind::conflict,
               "a run that is not in the way of the one from point " +
                   std::to_string(pieces[i].order / 2));
        break;
      }
  }
  std::vector<PlanPiece> pieces_along() const {
    std::vector<PlanPiece> pieces;
    for (std::size_t i = 0; i < plan_.runs.size(); ++i) {
      const WallRun& run = plan_.runs[i];
      pieces.push_back({{run.at(run.from, -half_), run.at(run.from, half_), run.at(run.to, half_),
                         run.at(run.to, -half_)},
                        2 * i});
      if (plan_.corners[i]) pieces.push_back({*plan_.corners[i], 2 * i + 1});
    }
    return pieces;
  }
  // A run and the next one, a corner and the run to either side.
  bool meet(std::size_t i, std::size_t j) const {
    const std::size_t all = 2 * plan_.runs.size(), apart = j - i;
    const std::size_t least = walls_.closed ? std::min(apart, all - apart) : apart;
    return least <= (i % 2 == 0 && j % 2 == 0 ? 2U : 1U);
  }
  // Walls that touch have no room in common.
  double tolerance() const {
    double far = 0;
    for (const PlanVector& p : walls_.points)
      far = std::max({far, std::fabs(p[0]), std::fabs(p[1])});
    return 1e-9 * walls_.thickness + rounding * far;
  }

  std::size_t next(std::size_t i) const { return (i + 1) % plan_.runs.size(); }

  const Walls& walls_;
  const Place points_;
  Faults& faults_;
  const double half_;
  WallPlan plan_;
};

}  // namespace

WallPlan wall_plan(const Walls& walls, const Place& at, Faults& faults) {
  return PlanMaking(walls, at.at("points"), faults)();
}

}  // namespace tia
