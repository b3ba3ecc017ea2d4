#include "core/radio/image_path.h"

#include <cmath>
#include <utility>

namespace tia {
namespace {

// The walls that a leg goes through are added. Returns: whether it may, and counts down `left`.
bool add_walls(const RadioWorld& world, const Leg& leg, int& left,
               std::vector<RadioInteraction>& out) {
  const std::vector<Crossed> met = world.crossings(leg);
  const Vec3d way = leg.to - leg.from;
  const double size = length(way);
  const std::size_t first = out.size();
  for (const Crossed& each : met) {
    const RadioBody& body = world.body(each.body);
    if (!body.lets_through()) return false;
    const double slope = dot(each.normal, way) / size;
    const bool enters = body.sheet || slope < 0;
    if (enters && left-- == 0) return false;
    double inside = 0;
    if (!body.sheet && !enters) {
      // Where it came in: the last entrance of that body that has not been left.
      for (std::size_t i = out.size(); i-- > first && inside == 0;)
        if (out[i].body == each.body && out[i].inside == 0)
          inside = out[i].inside = length(each.point - out[i].point);
      if (inside == 0) return false;  // it began inside
    }
    out.push_back({RadioKind::transmission, each.body, each.element, each.point, each.normal,
                   std::fabs(slope), inside});
  }
  for (std::size_t i = first; i < out.size(); ++i)
    if (!world.body(out[i].body).sheet && out[i].inside == 0) return false;  // it ends inside
  return true;
}

}  // namespace

int side_of(const RadioWorld& world, const Facet& facet, const Vec3d& source) {
  const double height = facet.face.height_of(source);
  if (std::fabs(height) <= world.slack()) return 0;
  if (height > 0) return 1;
  return facet.closed ? 0 : -1;
}

std::vector<Vec3d> images_of(const RadioWorld& world, const Vec3d& from,
                             std::span<const int> facets) {
  std::vector<Vec3d> images;
  Vec3d image = from;
  for (const int i : facets) images.push_back(image = world.facet(i).face.mirror(image));
  return images;
}

std::optional<RadioPath> mirrored_path(const RadioWorld& world, const Vec3d& from, const Vec3d& to,
                                       std::span<const int> facets, std::span<const Vec3d> images) {
  std::vector<RadioInteraction> met;  // most ways miss their last facet, and allocate nothing
  Vec3d target = to;
  for (std::size_t i = facets.size(); i-- > 0;) {
    const Facet& facet = world.facet(facets[i]);
    const Vec3d& source = i == 0 ? from : images[i - 1];
    const double above = facet.face.height_of(target), below = facet.face.height_of(images[i]);
    const int side = side_of(world, facet, source);
    if (side == 0 || !(side * above > world.slack())) return std::nullopt;
    const Vec3d way = target - images[i];
    const Vec3d p = images[i] + way * (below / (below - above));
    if (!world.holds(facets[i], p)) return std::nullopt;
    const double cosine = std::fabs(dot(facet.face.normal, way)) / length(way);
    if (met.empty()) met.resize(facets.size());
    met[i] = {RadioKind::reflection, facet.body, facet.element, p, facet.face.normal, cosine, 0};
    target = p;
  }
  return RadioPath{from, to, std::move(met),
                   length(facets.empty() ? to - from : to - images.back())};
}

bool is_free(const RadioWorld& world, RadioPath& path, std::span<const int> facets,
             int max_transmissions) {
  std::vector<RadioInteraction> all;
  int left = max_transmissions;
  for (std::size_t i = 0; i <= facets.size(); ++i) {
    const bool last = i == facets.size();
    const Leg leg{i == 0 ? path.from : path.interactions[i - 1].point,
                  last ? path.to : path.interactions[i].point,
                  i == 0 ? -1 : facets[i - 1],
                  last ? -1 : facets[i],
                  i > 0 && facets[i - 1] < 0,
                  !last && facets[i] < 0};
    if (max_transmissions == 0 ? world.blocked(leg) : !add_walls(world, leg, left, all))
      return false;
    if (!last) all.push_back(path.interactions[i]);
  }
  path.interactions = std::move(all);
  return true;
}

}  // namespace tia
