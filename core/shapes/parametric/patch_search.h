// The search for a line's hits of a parametric surface, patch by patch.
#pragma once

#include <vector>

#include "core/shapes/parametric/parametric_form.h"

namespace tia::detail {

/// SurfaceAt: the surface and its slopes at one (u, v).
struct SurfaceAt {
  double u = 0, v = 0;
  Vec3d point{}, by_u{}, by_v{};
};
SurfaceAt surface_at(const Program& surface, double u, double v);

/// Ascending in t, and those that are one only once: neighbouring patches share their edges.
/// Space/units: those whose brackets are no farther apart than `same` are one.
void put_in_order(std::vector<SurfaceHit>& found, double same);

class PatchSearch {
 public:
  PatchSearch(const ParametricForm& form, const Line& line, double after, double before,
              bool first_only, std::vector<SurfaceHit>& found);

  /// Returns: beyond what t nothing is looked for any more.
  double visit(std::int32_t leaf);
  /// In tests of a sphere, roughly.
  std::int64_t work() const;

 private:
  struct Projected;
  enum class Verdict { missed, one, unknown };

  Verdict judge(const SurfacePatch& patch, const Projected& p) const;
  void solve(const SurfacePatch& patch, const Projected& p);
  void part(const SurfacePatch& patch);
  void part_once(const SurfacePatch& patch, std::vector<SurfacePiece>& waiting);
  bool is_small(const SurfacePiece& piece) const;
  void accept_alone(double t);
  void accept(const SurfacePatch& patch);
  void accept(const SurfacePiece& piece);
  void accept(double t, const Bracket& bracket);
  Projected projected(const SurfacePatch& patch) const;

  const ParametricForm& form_;
  const Line& line_;
  Vec3d across_, aside_;  ///< unit, with the line's direction at right angles to each other
  double after_, before_;
  bool first_only_;
  std::vector<SurfaceHit>& found_;
  int element_ = 0, values_ = 0, eights_ = 0;
};

}  // namespace tia::detail
