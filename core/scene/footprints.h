// Buildings from a map: GeoJSON's polygons with heights, as a scene of blocks on a ground.
#pragma once

#include "core/input/value.h"
#include "core/scene/scene.h"
#include "core/scene/triangulation.h"

namespace tia {

/// Geodesy: degrees around a place as metres. Space/units: x east, z south, metres.
/// Source: Snyder, "Map projections, a working manual", USGS PP 1395 (1987), (4-18), (4-20): the
/// ellipsoid's radii of curvature, here of WGS 84, at the place's latitude; a kilometre away it is
/// right to a centimetre or two.
struct Geodesy {
  double longitude = 0, latitude = 0;  ///< degrees, of the origin
  double east = 0, north = 0;          ///< metres of a degree

  static Geodesy at(double longitude, double latitude);
  PlanPoint plan(double at_longitude, double at_latitude) const {
    return {(at_longitude - longitude) * east, (latitude - at_latitude) * north};
  }
};

/// A scene in metres: each polygon of a FeatureCollection, a Feature or a geometry a block, a mesh
/// that is closed, from `min_height` (0) to `height`, or else 3 m for each of `building:levels`, or
/// else 9 m up; around the middle of them all, on a plane. Rings may be either way round; holes are
/// yards. Points and lines are left out. Source: RFC 7946; the properties are OpenStreetMap's
/// ("Simple 3D Buildings").
/// Errors: InputError: what is no GeoJSON, rings that are not closed or have no area, heights that
/// are none, nothing to build.
Scene scene_of_footprints(const Value& geojson);

}  // namespace tia
