// What a key may do (`may` in TIA_KEYS_FILE): the routes say what they need, keys what they have.
#pragma once

#include <array>
#include <string_view>

#include "core/input/fields.h"

namespace tia::server {

/// Right: admin is for what is others'.
enum class Right { render, explain, scenes, models, jobs, metrics, admin };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::Right> {
  static constexpr std::array<std::string_view, 7> names{"render", "explain", "scenes", "models",
                                                         "jobs",   "metrics", "admin"};
};
