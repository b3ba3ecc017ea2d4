#include "core/shapes/composite/wall_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

#include "core/input/codec.h"
#include "core/input/json.h"
#include "core/shapes/composite/wall_plan.h"

namespace tia {
namespace {

/// PlacedOpening: one that is right, and its run. Space/units: along the run.
struct PlacedOpening {
  std::size_t run = 0;
  double from = 0, to = 0, sill = 0, lintel = 0;
};

/// OpeningsCheck: puts openings into their runs, and says which cannot be there.
class OpeningsCheck {
 public:
  OpeningsCheck(const Walls& walls, const std::vector<WallRun>& runs, const Place& at,
                Faults& faults)
      : walls_(walls), runs_(runs), openings_(at), faults_(faults) {}

  /// In the line's order.
  std::vector<PlacedOpening> operator()() {
    std::vector<std::size_t> order(walls_.openings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(
        order, [&](std::size_t a, std::size_t b) { return opening(a).from < opening(b).from; });
    std::vector<PlacedOpening> placed;
    std::optional<std::size_t> before;
    for (const std::size_t i : order) {
      if (faults_.full()) break;
      if (before && opening(i).from < opening(*before).to)
        refuse(i, "from", FaultKind::conflict, opening(i).from,
               "beyond the end of opening " + std::to_string(*before) + ", which is there too");
      else if (has_height(i)) place(i, placed);
      if (!before || opening(i).to > opening(*before).to) before = i;
    }
    return placed;
  }

 private:
  const Opening& opening(std::size_t i) const { return walls_.openings[i]; }

  void refuse(std::size_t i, const char* field, FaultKind kind, double got,
              const std::string& allowed) {
    const Place each = openings_.at(i);
    faults_.add({kind, each.at(field).pointer(), Value(got), allowed});
  }

  bool has_height(std::size_t i) {
    const Opening& o = opening(i);
    const double lintel = o.lintel.value_or(walls_.height);
    if (lintel > walls_.height)
      refuse(i, "lintel", FaultKind::out_of_range, lintel,
             "at most the walls' height, " + number_text(walls_.height));
    else if (o.sill >= lintel)
      refuse(i, "sill", FaultKind::out_of_range, o.sill,
             "below " + number_text(lintel) + ", where the opening ends");
    else return true;
    return false;
  }

  void place(std::size_t i, std::vector<PlacedOpening>& placed) {
    const Opening& o = opening(i);
    if (!(o.from < o.to))
      return refuse(i, "to", FaultKind::out_of_range, o.to,
                    "above " + number_text(o.from) + ", where it begins");
    const std::size_t k = run_at(o.from);
    const WallRun& run = runs_[k];
    // What is written in decimals may miss a corner by its rounding.
    const double same = 1e-9 * walls_.thickness + 1e-12 * (run.begin + run.length);
    const double from = o.from - run.begin, to = o.to - run.begin;
    const std::string between = number_text(run.begin + run.low) + " to " +
                                number_text(run.begin + run.high) +
                                ", between the corners of its run";
    if (from < run.low - same || from >= run.high)
      return refuse(i, "from", FaultKind::out_of_range, o.from, between);
    if (to > run.high + same) return refuse(i, "to", FaultKind::out_of_range, o.to, between);
    placed.push_back({k, std::max(from, run.low), std::min(to, run.high), o.sill,
                      o.lintel.value_or(walls_.height)});
  }
  // The last run that begins there or before.
  std::size_t run_at(double along) const {
    const auto beyond = std::ranges::upper_bound(runs_, along, {}, &WallRun::begin);
    return static_cast<std::size_t>(beyond - runs_.begin()) - 1;
  }

  const Walls& walls_;
  const std::vector<WallRun>& runs_;
  const Place openings_;
  Faults& faults_;
};

Affine frame_of(const WallRun& run) {
  return {{run.way[0], 0, run.way[1]},
          {0, 1, 0},
          {-run.way[1], 0, run.way[0]},
          {run.start[0], 0, run.start[1]}};
}

/// A prism over a corner, its outer side told by the order of its triangles' corners.
Mesh prism(const WallCorner& corner, double height) {
  std::vector<double> positions;
  for (const double y : {0.0, height})
    for (const Walls::Point& p : corner) positions.insert(positions.end(), {p[0], y, p[1]});
  std::vector<std::uint32_t> indices{4, 5, 6, 4, 6, 7, 0, 2, 1, 0, 3, 2};
  for (std::uint32_t a = 0; a < 4; ++a) {
    const std::uint32_t b = (a + 1) % 4;
    indices.insert(indices.end(), {a, b, b + 4, a, b + 4, a + 4});
  }
  Mesh mesh;
  mesh.positions.values = std::move(positions);
  mesh.indices.values = std::move(indices);
  return mesh;
}

/// Lowering: collects the pieces of a plan that is right.
class Lowering {
 public:
  explicit Lowering(const Walls& walls) : height_(walls.height), half_(walls.thickness / 2) {}

  void add(const WallRun& run, std::span<const PlacedOpening> openings) {
    double from = run.from;
    for (const PlacedOpening& each : openings) {
      box(run, {from, each.from}, {0, height_});
      box(run, {each.from, each.to}, {0, each.sill});
      box(run, {each.from, each.to}, {each.lintel, height_});
      from = each.to;
    }
    box(run, {from, run.to}, {0, height_});
  }
  void add(const WallCorner& corner) { pieces_.push_back({prism(corner, height_)}); }
  std::vector<WallPiece> pieces() && { return std::move(pieces_); }

 private:
  struct Stretch {
    double from = 0, to = 0;
  };

  void box(const WallRun& run, const Stretch& along, const Stretch& up) {
    if (!(along.from < along.to && up.from < up.to)) return;
    if (run.way[0] != 0 && run.way[1] != 0) {
      pieces_.push_back(
          {Box{{along.from, up.from, -half_}, {along.to, up.to, half_}}, frame_of(run)});
      return;
    }
    const Walls::Point a = run.at(along.from, -half_), b = run.at(along.to, half_);
    const Box box{{std::min(a[0], b[0]), up.from, std::min(a[1], b[1])},
                  {std::max(a[0], b[0]), up.to, std::max(a[1], b[1])}};
    if (box.min.x < box.max.x && box.min.z < box.max.z) pieces_.push_back({box});
  }

  const double height_, half_;
  std::vector<WallPiece> pieces_;
};

}  // namespace

std::vector<WallPiece> wall_pieces(const Walls& walls, const Place& at, Faults& faults) {
  const std::size_t before = faults.count();
  const WallPlan plan = wall_plan(walls, at, faults);
  if (faults.count() != before) return {};
  const std::vector<PlacedOpening> openings =
      OpeningsCheck(walls, plan.runs, at.at("openings"), faults)();
  if (faults.count() != before) return {};
  Lowering lowering(walls);
  const PlacedOpening* first = openings.data();
  const PlacedOpening* const end = first + openings.size();
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const PlacedOpening* const last =
        std::find_if(first, end, [&](const PlacedOpening& each) { return each.run != i; });
    lowering.add(plan.runs[i], {first, last});
    if (plan.corners[i]) lowering.add(*plan.corners[i]);
    first = last;
  }
  return std::move(lowering).pieces();
}

}  // namespace tia
