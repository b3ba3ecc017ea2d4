// Why a pixel looks as it does: what its ray meets, in words and in double.
#pragma once

#include <vector>

#include "core/accel/all_hits.h"
#include "core/scene/labels.h"

namespace tia {

/// ExplainedHit: one crossing of the ray, with the object that it belongs to.
struct ExplainedHit {
  ObjectLabel object;
  Meeting at;
};

/// Explanation. Space/units: world space; the ray's direction is unit.
struct Explanation {
  Ray<double> ray;
  std::vector<ExplainedHit> hits;  ///< all along the ray, the nearest first
};

/// Domain: a ray of unit direction. Errors: InputError (limit) where it crosses too much.
Explanation explain(const Scene& scene, const Ray<double>& ray);

/// {"ray": {"origin", "direction"}, "hits": [{"t", "object", "type", "point", "normal", "uv",
/// "front"}]}.
Value::Object value_of(const Explanation& explanation);

}  // namespace tia
