// The few functions that a host may call: text -> Scene -> World -> blocks -> film -> bytes.
//   read_scene  press / with_light  compile  view_of  render  encode_png / encode_pfm
// and explain, of one ray.
#pragma once

#include "core/film/film.h"
#include "core/film/pfm.h"
#include "core/film/png.h"
#include "core/render/explain.h"
#include "core/render/render.h"
#include "core/scene/keys.h"
#include "core/scene/limits.h"
#include "core/scene/read_scene.h"
#include "core/version.h"
