#include "core/shapes/formula/isosurface.h"

#include <bit>
#include <cmath>

#include "core/shapes/formula/gradient.h"
#include "core/shapes/formula/isosurface_root.h"
#include "core/shapes/formula/isosurface_search.h"

namespace tia {

IsosurfaceForm isosurface_form(Program function, const Region& region) {
  IsosurfaceForm form{std::move(function), region, nullptr};
  form.cells = std::make_shared<const IsosurfaceCells>(cells_of(form.function, region));
  return form;
}

bool detail::is_inside(const IsosurfaceForm& form, const Vec3d& p) {
  return IsosurfaceLine(form.function, {p, {0, 0, 0}}).value(0) < 0;
}

// The search ends at `enough` only between cells: to cut one would change the last bits of its
// roots.
std::int64_t detail::follow(const IsosurfaceForm& form, const Line& line,
                            const IsosurfaceStretch& stretch, IsosurfaceListener& listener) {
  const double from = stretch.from, to = stretch.to;
  IsosurfaceSearch search(form.function, line, std::max(std::fabs(from), std::fabs(to)), listener,
                          stretch.brackets_alone);
  const Vec3d start = line.origin - form.cells->tree.middle;
  const std::int64_t nodes = traverse(
      form.cells->tree, line, from, to, [&](std::uint32_t leaf, double in, double out, double end) {
        if (in > stretch.enough) return -Aabb::far;
        const IsosurfaceCell& cell = form.cells->cells[leaf];
        return search.visit(cell, start, in, out) ? end : -Aabb::far;
      });
  return 4 * nodes + search.work();
}

namespace {

// The first crossing beyond `after`, or what brackets it.
class FirstEvent {
 public:
  FirstEvent(const IsosurfaceForm& form, const Line& line, double after, double before,
             bool brackets_alone) {
    const Chord within = chord(form.region, line);
    const double from = std::max(within.in.t, after);
    if (within.empty() || !(from <= std::min(within.out.t, before))) return;
    detail::CallbackListener listener([&](const IsosurfaceEvent& event) {
      const double last = event.tolerance < 0 ? event.t : event.bracket.to;
      found = event.is_root && last > after;
      if (found) root = event;
      return !found;
    });
    work = detail::follow(form, line, {from, within.out.t, before, brackets_alone}, listener);
  }

  bool found = false;
  IsosurfaceEvent root;
  std::int64_t work = 0;
};

/// EightBrackets: the brackets of the lanes whose roots are not yet found.
class EightBrackets {
 public:
  void set(std::size_t lane, const IsosurfaceEvent& event) {
    const std::array<double, 4> all{event.bracket.from, event.bracket.to, event.t, event.tolerance};
    for (std::size_t k = 0; k < all.size(); ++k) parts_[k][lane] = all[k];
    open_ |= 1U << lane;
    if (!event.inside) inside_from_ |= 1U << lane;
  }
  unsigned open() const { return open_; }
  Octet roots(const Program& function, const Ray<Octet>& line) const {
    const auto of = [&](std::size_t k) { return Octet::load_unaligned(parts_[k].data()); };
    const Octet nowhere(std::numeric_limits<double>::quiet_NaN());
    return detail::root_of<Octet>(
        function, line,
        {select(mask_of(open_), of(0), nowhere), of(1), of(2), mask_of(inside_from_), of(3)});
  }

 private:
  std::array<std::array<double, 8>, 4> parts_{};
  unsigned open_ = 0, inside_from_ = 0;
};

}  // namespace

EightCrossings first_crossings(const IsosurfaceForm& form, const EightLines& eight) {
  EightCrossings all;
  EightBrackets brackets;
  const auto search = [&](int i, bool brackets_alone) {
    const FirstEvent first(form, eight.line_of(i), lane(eight.after, i), lane(eight.before, i),
                           brackets_alone);
    all.work += first.work;
    const auto at = static_cast<std::size_t>(i);
    all.t[at] = first.found ? first.root.t : Aabb::far;
    if (first.found && first.root.tolerance >= 0) brackets.set(at, first.root);
  };
  for (unsigned left = eight.wanted; left != 0; left &= left - 1)
    search(std::countr_zero(left), true);
  if (brackets.open() != 0) {
    const Octet t = brackets.roots(form.function, eight.line);
    for (unsigned left = brackets.open(); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      all.t[static_cast<std::size_t>(i)] = lane(t, i);
      // Where a bracket contains `after`, the root may be before it.
      if (!(lane(t, i) > lane(eight.after, i))) search(i, false);
    }
  }
  for (int i = 0; i < 8; ++i) {
    double& t = all.t[static_cast<std::size_t>(i)];
    if (!(t < lane(eight.before, i))) t = Aabb::far;
  }
  return all;
}

namespace {

template <class Real>
Vec3<Real> direction_of_gradient(const Program& function, const Vec3<Real>& p) {
  using D = Dual<Real, 3>;
  const std::array<D, 3> at{D::variable(p.x, 0), D::variable(p.y, 1), D::variable(p.z, 2)};
  return direction_of(evaluate(function, at.data()).slope);
}

}  // namespace

Vec3d normal(const IsosurfaceForm& form, const Vec3d& p, int element) {
  return element > 0 ? normal(form.region, p, element - 1)
                     : direction_of_gradient(form.function, p);
}
Vec3<Octet> normals(const IsosurfaceForm& form, const Vec3<Octet>& p) {
  return direction_of_gradient(form.function, p);
}

Vec2d uv(const IsosurfaceForm& form, const Vec3d& p, int element) {
  if (element > 0) return uv(form.region, p, element - 1);
  return longitude_latitude(p - bounds(form.region).center());
}

std::size_t heap_bytes(const IsosurfaceForm& form) {
  return heap_bytes(form.function.instructions) + heap_bytes(form.function.results) +
         2 * heap_block + sizeof(IsosurfaceCells) + heap_bytes(form.cells->tree.nodes) +
         heap_bytes(form.cells->cells);
}

}  // namespace tia
