#include "core/accel/world/path_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/math/onb.h"

namespace tia {
namespace {

// ---- areas of shapes ------------------------------------------------------------------------

// How much a map stretches, where it does so alike in all directions and keeps right angles; else
// 0.
double scale_of(const Affine& map) {
  const double x = dot(map.x, map.x), y = dot(map.y, map.y), z = dot(map.z, map.z);
  const double most = 1e-9 * x;
  const bool alike = std::fabs(x - y) <= most && std::fabs(x - z) <= most &&
                     std::fabs(dot(map.x, map.y)) <= most && std::fabs(dot(map.y, map.z)) <= most &&
                     std::fabs(dot(map.z, map.x)) <= most;
  return alike ? std::sqrt(x) : 0;
}
bool keeps_right_angles(const Affine& map) {
  const double x = length(map.x), y = length(map.y), z = length(map.z);
  return std::fabs(dot(map.x, map.y)) <= 1e-9 * x * y &&
         std::fabs(dot(map.y, map.z)) <= 1e-9 * y * z &&
         std::fabs(dot(map.z, map.x)) <= 1e-9 * z * x;
}

using Forms = std::vector<PathForm>;

template <class Kind>
Forms areas_of(const Kind&, const Affine&) {
  return {};
}
Forms areas_of(const Sphere& sphere, const Affine& place) {
  const double scale = scale_of(place);
  if (scale == 0) return {};
  return {SphereForm{place.point(sphere.center), sphere.radius * scale}};
}
Forms areas_of(const Triangle& t, const Affine& place) {
  return {TriangleArea{place.point(t.a), place.vector(t.b - t.a), place.vector(t.c - t.a)}};
}
Forms areas_of(const Disc& disc, const Affine& place) {
  const Onb frame = onb_around(unit(disc.normal));
  return {DiscArea{place.point(disc.center), place.vector(frame.u * disc.radius),
                   place.vector(frame.v * disc.radius)}};
}
Forms areas_of(const Box& box, const Affine& place) {
  if (!keeps_right_angles(place)) return {};
  const Vec3d half = (box.max - box.min) * 0.5;
  return {
      BoxArea{place.point(box.min + half), place.x * half.x, place.y * half.y, place.z * half.z}};
}
Forms areas_of(const Cylinder& c, const Affine& place) {
  const double scale = scale_of(place);
  if (scale == 0) return {};
  return {CylinderArea{place.point(c.base), place.vector(c.cap - c.base), c.radius * scale}};
}
Forms areas_of(const Mesh& mesh, const Affine& place) {
  const auto& indices = mesh.indices.values.get();
  const auto& positions = mesh.positions.values.get();
  if (indices.size() / 3 > most_areas) return {};
  const auto corner = [&](std::size_t i) {
    const auto at = 3 * static_cast<std::size_t>(indices[i]);
    return place.point(Vec3d{positions[at], positions[at + 1], positions[at + 2]});
  };
  Forms forms;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Vec3d a = corner(i);
    forms.push_back(TriangleArea{a, corner(i + 1) - a, corner(i + 2) - a});
  }
  return forms;
}

void move_by(Constant& at, const Vec3d& way) { at = at.exact + way; }
void move_by(PointForm& form, const Vec3d& way) { move_by(form.middle, way); }
void move_by(SpotForm& form, const Vec3d& way) { move_by(form.position, way); }
void move_by(SphereForm& form, const Vec3d& way) { move_by(form.middle, way); }
void move_by(DirectionalForm&, const Vec3d&) {}
void move_by(SunForm&, const Vec3d&) {}
void move_by(TriangleArea& form, const Vec3d& way) { form.a = form.a + way; }
void move_by(QuadArea& form, const Vec3d& way) { form.corner = form.corner + way; }
void move_by(DiscArea& form, const Vec3d& way) { form.center = form.center + way; }
void move_by(BoxArea& form, const Vec3d& way) { form.center = form.center + way; }
void move_by(CylinderArea& form, const Vec3d& way) { form.base = form.base + way; }

// ---- what the tree knows of each ------------------------------------------------------------

LightBounds at_point(const Vec3d& p, double power) { return {{p, p}, power}; }

LightBounds bounds_of(const PointForm& form, double light) {
  return at_point(form.middle.exact, 4 * pi * light);
}
LightBounds bounds_of(const SpotForm& form, double light) {
  LightBounds bounds = at_point(form.position.exact,
                                2 * pi * (1 - (form.cos_radius + form.cos_falloff) / 2) * light);
  bounds.axis = form.axis.exact, bounds.cos_o = 1, bounds.cos_e = form.cos_falloff;
  return bounds;
}
LightBounds bounds_of(const SphereForm& form, double light) {
  const Vec3d reach{form.radius, form.radius, form.radius}, p = form.middle.exact;
  return {{p - reach, p + reach}, 4 * pi * pi * form.radius * form.radius * light};
}
template <DrawsByArea Form>
LightBounds bounds_of(const Form& form, double light) {
  const Extent extent = extent_of(form);
  LightBounds bounds{extent.box, pi * extent.area * light};
  if (extent.normal == Vec3d{} || !(extent.area > 0)) return bounds;
  bounds.axis = unit(extent.normal), bounds.cos_o = 1, bounds.two_sided = true;
  bounds.power *= 2;
  return bounds;
}
LightBounds bounds_of(const DirectionalForm&, double) { return {}; }
LightBounds bounds_of(const SunForm&, double) { return {}; }

LightBounds bounds_of(const PathLight& light) {
  const Vec3d& c = light.color.exact;
  const double bright = 0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z;
  return std::visit([&](const auto& form) { return bounds_of(form, bright); }, light.form);
}

bool is_endless(const PathLight& light) {
  return std::holds_alternative<DirectionalForm>(light.form) ||
         std::holds_alternative<SunForm>(light.form);
}

PathLight path_light(const WorldLight& light) {
  PathLight own{{}, light.color, light.primitive, light.instance, -1, true};
  std::visit(
      [&]<class Form>(const Form& form) {
        if constexpr (std::same_as<Form, QuadForm>)
          own.form = QuadArea{form.corner.exact, form.u.exact, form.v.exact};
        else own.form = form;
      },
      light.form);
  return own;
}

auto place_of(const PathLight& light) {
  return std::tuple(light.primitive, light.instance, light.element);
}

}  // namespace

void add_areas(const Shape& shape, const Affine& place, const PathLight& light,
               std::vector<PathLight>& lights) {
  const Forms forms = std::visit([&](const auto& kind) { return areas_of(kind, place); }, shape);
  if (lights.size() + forms.size() > most_areas) return;
  for (std::size_t i = 0; i < forms.size(); ++i) {
    PathLight& own = lights.emplace_back(light);
    own.form = forms[i];
    own.element = std::holds_alternative<Mesh>(shape) ? static_cast<int>(i) : -1;
    own.is_bare = std::holds_alternative<SphereForm>(own.form);
  }
}

void move_by(PathLight& light, const Vec3d& way) {
  std::visit([&](auto& form) { move_by(form, way); }, light.form);
}

LitSpans lit_spans(const PathLight& light, const Vec3d& origin, const Vec3d& direction) {
  return std::visit(
      [&]<class Form>(const Form& form) {
        if constexpr (LeavesDark<Form>) return lit_spans(form, origin, direction);
        else return LitSpans::whole();
      },
      light.form);
}

PathLights::PathLights(const std::vector<WorldLight>& lights, const std::vector<PathLight>& areas,
                       std::size_t skies)
    : lights_(areas) {
  for (const WorldLight& light : lights)
    if (!light.name.empty()) lights_.push_back(path_light(light));
  const auto far = std::stable_partition(lights_.begin(), lights_.end(),
                                         [](const PathLight& light) { return !is_endless(light); });
  near_ = static_cast<int>(far - lights_.begin());
  std::stable_sort(lights_.begin(), far, [](const PathLight& a, const PathLight& b) {
    return place_of(a) < place_of(b);
  });
  std::vector<LightBounds> bounds;
  double power = 0;
  for (int i = 0; i < near_; ++i) {
    power += bounds.emplace_back(bounds_of((*this)[i])).power;
    middles_.push_back(bounds.back().box.center());
  }
  if (knows_places()) tree_ = LightTree(bounds);
  else
    for (const LightBounds& each : bounds)
      shares_.push_back(power > 0 ? each.power / power : 1.0 / near_);
  groups_ = size() - near_ + static_cast<int>(skies) + (near_ > 0 ? 1 : 0);
}

PathChoice PathLights::choose(const Vec3d& p, const Vec3d& n, double u) const {
  const double scaled = u * groups_;
  const int group = std::min(static_cast<int>(scaled), groups_ - 1);
  const double chance = 1.0 / groups_;
  if (near_ == 0) return {group, chance};
  if (group > 0) return {near_ + group - 1, chance};
  double left = scaled - group;
  if (knows_places()) {
    const LightTree::Choice chosen = tree_.choose(p, n, left);
    return {chosen.light, chosen.chance * chance};
  }
  int light = 0;
  while (light + 1 < near_ && left >= share(light)) left -= share(light++);
  return {light, share(light) * chance};
}

double PathLights::chance(int light, const Vec3d& p, const Vec3d& n) const {
  const double chance = 1.0 / groups_;
  if (light >= near_) return chance;
  return chance * (knows_places() ? tree_.chance(light, p, n) : share(light));
}

int PathLights::at(int primitive, int instance, int element) const {
  const auto end = lights_.begin() + near_;
  // That of the whole surface, or else the element's own.
  for (const int each : {-1, element}) {
    const auto wanted = std::tuple(primitive, instance, each);
    const auto found = std::lower_bound(
        lights_.begin(), end, wanted,
        [](const PathLight& light, const auto& place) { return place_of(light) < place; });
    if (found != end && place_of(*found) == wanted)
      return static_cast<int>(found - lights_.begin());
  }
  return -1;
}

}  // namespace tia
