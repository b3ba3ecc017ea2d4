#include "core/shapes/parametric/patch_search.h"

#include <algorithm>
#include <cmath>

#include "core/math/onb.h"
#include "core/parallel/per_thread.h"

namespace tia::detail {
namespace {

// The budget of one line, in evaluations of eight patches. One patch may take a share of what is
// left, and at least enough for a pole.
constexpr int most_evaluations = 400, patch_share = 4, least_evaluations = 16,
              last_evaluations = 1600;
// A patch of these shares of the domain's sides, or of the surface's size, is divided no further.
// The second ends the division at a pole, where all u are the same point.
constexpr double least_share = 0x1p-30, least_size = 0x1p-36;
// Rectangles are enlarged by this share, so that a line cannot pass between two of them: Newton's
// solution in either is good to some 1e-14.
constexpr double overlap = 1e-9;
constexpr std::string_view alone = "interval arithmetic proves one solution in the patch at most";
constexpr std::string_view small = "the patch is as small as the numbers tell apart";

bool meets(const Aabb& box, const Line& line) {
  double in = -Aabb::far, out = Aabb::far;
  const auto slab = [&](double low, double high, double o, double d) {
    const double one = (low - o) / d, other = (high - o) / d;
    in = std::max(in, std::min(one, other));
    out = std::min(out, std::max(one, other));
    return d != 0 || (low <= o && o <= high);
  };
  const Vec3d &o = line.origin, &d = line.direction;
  return slab(box.min.x, box.max.x, o.x, d.x) && slab(box.min.y, box.max.y, o.y, d.y) &&
         slab(box.min.z, box.max.z, o.z, d.z) && in <= out;
}

Vec3d magnitude(const Vec3d& v) { return upper(v, -v); }

/// A 2x2 matrix by rows.
struct Matrix {
  double a, b, c, d;
  double determinant() const { return a * d - b * c; }
  Matrix inverse() const {
    const double over = 1 / determinant();
    return {d * over, -b * over, -c * over, a * over};
  }
  Vec2d operator*(const Vec2d& x) const { return {a * x.u + b * x.v, c * x.u + d * x.v}; }
  Matrix magnitude() const { return {std::fabs(a), std::fabs(b), std::fabs(c), std::fabs(d)}; }
};

}  // namespace

SurfaceAt surface_at(const Program& surface, double u, double v) {
  using D = Dual<double, 2>;
  Anywhere where;
  const std::array<D, 2> variables{D::variable(u, 0), D::variable(v, 1)};
  const D* const slots = run(surface, variables.data(), where);
  const D &x = slots[surface.results[0]], &y = slots[surface.results[1]],
          &z = slots[surface.results[2]];
  return {u,
          v,
          {x.value, y.value, z.value},
          {x.slope[0], y.slope[0], z.slope[0]},
          {x.slope[1], y.slope[1], z.slope[1]}};
}

void put_in_order(std::vector<SurfaceHit>& found, double same) {
  std::sort(found.begin(), found.end(), [](const SurfaceHit& a, const SurfaceHit& b) {
    return a.at.t != b.at.t ? a.at.t < b.at.t : a.at.element < b.at.element;
  });
  std::size_t kept = 0;
  double to = -Aabb::far;
  for (const SurfaceHit& each : found) {
    if (kept == 0 || !(each.bracket.from - to <= same)) {
      found[kept++] = each;
      to = each.bracket.to;
    } else {
      to = std::max(to, each.bracket.to);
    }
  }
  found.resize(kept);
}

/// Projected: a patch as the line sees it, whose hits are where the projection is 0.
struct PatchSearch::Projected {
  Vec2d off;              // of the patch's middle
  Matrix slopes, spread;  // of the projection by u and v
};

PatchSearch::PatchSearch(const ParametricForm& form, const Line& line, double after, double before,
                         bool first_only, std::vector<SurfaceHit>& found)
    : form_(form),
      line_(line),
      after_(after),
      before_(before),
      first_only_(first_only),
      found_(found) {
  const Onb basis = onb_around(line.direction);
  across_ = basis.u;
  aside_ = basis.v;
}

std::int64_t PatchSearch::work() const {
  return (std::int64_t(values_) + 12 * std::int64_t(eights_)) * (1 + form_.surface.cost / 4);
}

PatchSearch::Projected PatchSearch::projected(const SurfacePatch& p) const {
  const Vec3d off = p.middle - line_.origin;
  const Vec3d across = magnitude(across_), aside = magnitude(aside_);
  return {{dot(across_, off), dot(aside_, off)},
          {dot(across_, p.by_u), dot(across_, p.by_v), dot(aside_, p.by_u), dot(aside_, p.by_v)},
          {dot(across, p.spread_u), dot(across, p.spread_v), dot(aside, p.spread_u),
           dot(aside, p.spread_v)}};
}

// With Y the inverse of the middle slopes J, every solution x in the rectangle X is in
// -Y f + (I - Y J')(X), J' what the slopes may be; where that shrinks X there is one at most.
// Source: Krawczyk's operator; Moore, Kearfott, Cloud (2009), 8.2.
PatchSearch::Verdict PatchSearch::judge(const SurfacePatch& patch, const Projected& p) const {
  if (!patch.smooth) return Verdict::unknown;
  const Matrix inverse = p.slopes.inverse();
  const Vec2d half{patch.where.half_u, patch.where.half_v};
  const Vec2d middle = inverse * p.off, room = inverse.magnitude() * (p.spread * half);
  if (std::fabs(middle.u) - room.u > half.u * (1 + overlap) ||
      std::fabs(middle.v) - room.v > half.v * (1 + overlap))
    return Verdict::missed;
  return room.u < half.u && room.v < half.v ? Verdict::one : Verdict::unknown;
}

double PatchSearch::visit(std::int32_t leaf) {
  element_ = leaf;
  const SurfacePatch& patch = form_.patches->patches[static_cast<std::size_t>(leaf)];
  const Projected p = projected(patch);
  switch (judge(patch, p)) {
    case Verdict::missed: break;
    case Verdict::one: solve(patch, p); break;
    case Verdict::unknown: part(patch); break;
  }
  return before_;
}

// Newton's method with u and v clamped to the patch, so that it converges to the patch's solution.
void PatchSearch::solve(const SurfacePatch& patch, const Projected& p) {
  constexpr int most_steps = 30, most_own = 10;
  constexpr double close = 1e-7;  // the error after a step is about its square, 1e-14
  const Rectangle& r = patch.where;
  const Matrix first = p.slopes.inverse();
  const auto in_u = [&](double u) {
    return std::clamp(u, r.u - r.half_u * (1 + overlap), r.u + r.half_u * (1 + overlap));
  };
  const auto in_v = [&](double v) {
    return std::clamp(v, r.v - r.half_v * (1 + overlap), r.v + r.half_v * (1 + overlap));
  };
  const Vec2d start = first * p.off;
  double u = in_u(r.u - start.u), v = in_v(r.v - start.v);
  for (int i = 0; i < most_steps; ++i) {
    ++values_;
    const SurfaceAt at = surface_at(form_.surface, u, v);
    const Vec3d off = at.point - line_.origin;
    const Matrix slopes{dot(across_, at.by_u), dot(across_, at.by_v), dot(aside_, at.by_u),
                        dot(aside_, at.by_v)};
    // The middle slopes come closer with every step, if slowly.
    const Matrix inverse = i < most_own ? slopes.inverse() : first;
    const Vec2d step = inverse * Vec2d{dot(across_, off), dot(aside_, off)};
    const double next_u = in_u(u - step.u), next_v = in_v(v - step.v);
    const bool there =
        std::fabs(next_u - u) <= close * r.half_u && std::fabs(next_v - v) <= close * r.half_v;
    if (there) {
      if (std::fabs(step.u) <= 2 * close * r.half_u && std::fabs(step.v) <= 2 * close * r.half_v)
        accept_alone(dot(line_.direction, off - at.by_u * step.u - at.by_v * step.v));
      return;
    }
    if (!std::isfinite(next_u) || !std::isfinite(next_v)) {
      u = in_u(r.u), v = in_v(r.v);
      i = std::max(i, most_own);
      continue;
    }
    u = next_u, v = next_v;
  }
}

void PatchSearch::accept_alone(double t) { accept(t, {t, t, alone}); }

void PatchSearch::part(const SurfacePatch& patch) {
  if (eights_ >= last_evaluations) return accept(patch);
  const int most =
      eights_ + std::max(least_evaluations, (most_evaluations - eights_) / patch_share);
  auto& waiting = per_thread<std::vector<SurfacePiece>, struct Waiting>();
  waiting.clear();
  part_once(patch, waiting);
  while (!waiting.empty()) {
    const SurfacePiece next = waiting.back();
    waiting.pop_back();
    if (is_small(next) || eights_ >= most) accept(next);
    else part_once(next.patch, waiting);
  }
}

void PatchSearch::part_once(const SurfacePatch& patch, std::vector<SurfacePiece>& waiting) {
  ++eights_;
  for (const SurfacePiece& piece : pieces_of(form_.surface, eighths(patch))) {
    if (piece.box.empty() || !meets(piece.box, line_)) continue;
    const Projected p = projected(piece.patch);
    const Verdict verdict = judge(piece.patch, p);
    if (verdict == Verdict::one) solve(piece.patch, p);
    else if (verdict == Verdict::unknown) waiting.push_back(piece);
  }
}

bool PatchSearch::is_small(const SurfacePiece& piece) const {
  const Rectangle &r = piece.patch.where, &all = form_.domain;
  const Vec3d size = piece.box.size(), whole = form_.patches->box.size();
  return std::max({size.x, size.y, size.z}) <= least_size * std::max({whole.x, whole.y, whole.z}) ||
         (r.half_u <= least_share * all.half_u && r.half_v <= least_share * all.half_v);
}

void PatchSearch::accept(const SurfacePatch& patch) {
  const Vec3d half =
      magnitude(patch.by_u) * patch.where.half_u + magnitude(patch.by_v) * patch.where.half_v;
  if (std::isfinite(dot(half, half)) && std::isfinite(dot(patch.middle, patch.middle)))
    accept({patch, {patch.middle - half, patch.middle + half}});
}

void PatchSearch::accept(const SurfacePiece& piece) {
  if (!piece.box.bounded()) return;
  const double t = dot(line_.direction, piece.patch.middle - line_.origin);
  const double reach = dot(magnitude(line_.direction), piece.box.size()) / 2;
  accept(t, {t - reach, t + reach, small});
}

void PatchSearch::accept(double t, const Bracket& bracket) {
  if (!(t > after_ && t < before_)) {
    // Of equally near ones the lowest element, as in all hits.
    if (first_only_ && !found_.empty() && t == before_ && element_ < found_[0].at.element)
      found_[0].at.element = element_;
    return;
  }
  if (first_only_) {
    found_.clear();
    before_ = t;
  }
  found_.push_back({{t, element_}, bracket});
}

}  // namespace tia::detail
