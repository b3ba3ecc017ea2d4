// Pictures as files, whatever film they were on.
#pragma once

#include <stop_token>
#include <string>

#include "core/film/image.h"
#include "core/film/scanlines.h"
#include "core/parallel/workers.h"
#include "server/requests/plan.h"

namespace tia::server {

/// PictureEncoding: makes a plan's file of its pixels; without one of its pixels' bytes alone.
/// Errors: what the workers throw; Stopped.
struct PictureEncoding {
  const Plan& plan;
  const Workers& workers;
  const std::stop_token& stop;
  const std::string& recipe;  ///< that a PNG carries

  std::string operator()(Image light) const;
  std::string operator()(const Scanlines& rows) const;
  std::string operator()(const Image8& codes) const;
  std::string operator()(const ImageRgba8& codes) const;
};

}  // namespace tia::server
