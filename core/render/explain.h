// Explanations of pixels: all hits of a pixel's ray, in double, and every term of its colour, as
// the picture adds them.
#pragma once

#include <stop_token>

#include "core/input/codec.h"
#include "core/render/explanation.h"
#include "core/render/explanation_size.h"
#include "core/render/render.h"
#include "core/scene/view.h"

namespace tia {

/// A ray that belongs to no picture. Domain: the scene's world; a unit direction; an integrator
/// that is whitted. Errors: InputError (limit) where it crosses too much or its JSON would be
/// longer than longest_explanation, which is counted before it takes memory; Stopped.
Explanation explain(const Scene& scene, World world, const Ray<double>& ray,
                    const RenderOptions& options, const std::stop_token& stop = {});
/// The ray of the sample of pixel (x, y); its tree's colour is that sample's, bit for bit. Scene,
/// world and view are those of the sample's stratum of the open time.
/// Domain: a pixel of the view, one of the options' samples. Errors: as above; out_of_range where
/// that has no ray (SeenRay).
Explanation explain(const Scene& scene, World world, const View& view, int x, int y, int sample,
                    const RenderOptions& options, const std::stop_token& stop = {});

/// {"pixel", "sample", "hits": [{"t", "object", "id", "type", "point", "normal", "uv", "front",
/// of a copy "copy": [[i, j, k], ...], one of each group around it that is repeated, and of an
/// equation's root "root": {"bracket": [from, to], "how", "degree"}}],
/// "tree": {"ray", "depth", "winner", "winner_id", "winner_copy", "point", "normal", "terms",
/// "color"}, "objects": [{"id", "name", "pointer", "type"}], and, where there is something to note,
/// "notes": [{"pointer", "about"}]}. An object's id is its number in the
/// image of the integrator `object`; it tells those apart that have one name.
Value::Object value_of(const Explanation& explanation);
/// The schema of that, and of what is told of paths.
Value explanation_schema(Definitions& named);

}  // namespace tia
