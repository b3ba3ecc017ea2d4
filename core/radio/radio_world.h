// RadioWorld: what waves meet on their ways, facets in double by an index of their own and curved
// bodies through the compiled world.
#pragma once

#include <optional>
#include <vector>

#include "core/accel/world/world.h"
#include "core/boxes/bvh.h"
#include "core/radio/radio_body.h"

namespace tia {

/// Crossed: where a leg meets a surface. `facet` -1: of a curved body.
struct Crossed {
  double distance = 0;
  int facet = -1, body = 0, element = 0;
  Vec3d point{}, normal{};
};

/// Leg: a straight part of a path. It starts and ends on facets or curved bodies, which do not
/// block it there; -1: in the air.
struct Leg {
  Vec3d from{}, to{};
  int from_facet = -1, to_facet = -1;
  bool from_curved = false, to_curved = false;
};

/// RadioWorld. Space/units: scene units, scene space. Constant, shared by threads.
class RadioWorld {
 public:
  /// Errors: InputError of scenes with too much; Stopped.
  explicit RadioWorld(const Scene& scene, const Wave& wave = {}, const Workers& workers = {});

  const RadioBodies& all() const { return all_; }
  const Facet& facet(int i) const { return all_.facets[static_cast<std::size_t>(i)]; }
  const RadioBody& body(int i) const { return all_.bodies[static_cast<std::size_t>(i)]; }
  const std::vector<Facet>& facets() const { return all_.facets; }
  /// The bodies that are not made of facets.
  const std::vector<int>& curved() const { return curved_; }
  /// Below this, places are the same: 1e-9 of the largest coordinate.
  double slack() const { return slack_; }
  /// Around all that is bounded.
  const Aabb& bounds() const { return bounds_; }
  const Bvh& bvh() const { return bvh_; }
  const std::vector<std::uint32_t>& endless() const { return endless_; }
  const FacetPiece& piece(std::uint32_t i) const { return all_.pieces[i]; }

  /// Whether a point of a facet's plane is in the facet.
  bool holds(int facet, const Vec3d& p) const;
  /// Whether anything is between the ends.
  bool blocked(const Leg& leg) const;
  /// Everything between the ends, from the first on.
  std::vector<Crossed> crossings(const Leg& leg) const;
  /// What a ray from a facet, or from the air (-1), meets first. Domain: unit direction.
  std::optional<Crossed> first(const Vec3d& from, const Vec3d& direction, int from_facet) const;
  /// The same from a curved body's surface.
  std::optional<Crossed> first_from_curved(const Vec3d& from, const Vec3d& direction) const;
  /// Where a ray meets a facet's plane, or (facet -1) first a body's curved surface.
  std::optional<Crossed> meet_mirror(const Vec3d& from, const Vec3d& direction, int facet, int body,
                                     bool from_curved) const;
  /// A body whose inside or surface a point is in; -1: none.
  int body_around(const Vec3d& p) const;

 private:
  template <class Found>
  void meet(const Vec3d& from, const Vec3d& way, double& limit, Found found) const;
  void add_curved(const Leg& leg, std::vector<Crossed>& out) const;
  std::optional<Crossed> first(const Vec3d& from, const Vec3d& direction, int from_facet,
                               bool from_curved) const;
  double reach_from(const Vec3d& p) const;

  RadioBodies all_;
  std::vector<int> curved_;
  std::vector<std::uint32_t> endless_;  // facets
  Bvh bvh_;                             // over the pieces
  std::optional<World> world_;          // only where there is something curved
  Aabb bounds_;
  double slack_ = 0;
};

}  // namespace tia
