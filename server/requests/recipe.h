// Recipes: the canonical request of a picture and the version that draws it, as text. Requests that
// ask for the same picture in other words have the same recipe, another picture has another one:
// so its SHA-256 is the picture's entity tag, known before any ray. A PNG carries it as its text.
#pragma once

#include <stop_token>
#include <string>
#include <string_view>

#include "server/operation/config.h"
#include "server/requests/plan.h"

namespace tia::server {

/// The keyword of a recipe's iTXt chunk.
constexpr std::string_view recipe_keyword = "Tia recipe";

/// Objects of which more bytes are hashed are not told in recipes, but their digest: to write a
/// million triangles takes longer than to draw them. Such a picture cannot be drawn again from
/// itself. Keys that are longer are left out: the picture is the same.
constexpr std::size_t most_told_bytes = 256 << 10;

/// The scene that a recipe tells: the plain one, or whose strata of time are drawn.
inline const KnownScene& told_scene_of(const Plan& plan) {
  return plan.exposure.blurs() ? plan.exposure.moving : plan.scene;
}

/// Returns: {"request":{…},"version":"…"}: what POST /render takes, without what is as it would be
/// anyhow, or changes no byte. The scene is whole, after its key or light and with the options that
/// hold; plain, but of a picture that motion blurs, which tells the moving one (exposed_scene) and
/// the time. Canonical text (RFC 8785).
std::string recipe_of(const PictureRequest& asked, const Plan& plan);

/// What rounds over a picture are kept by: all that decides their sums, as its recipe without how
/// many samples there are to be. Returns: empty where what they come to is of no use to another
/// drawing: without chance, with a threshold, of a sheet, to be denoised.
std::string rounds_name_of(const PictureRequest& asked, const Plan& plan);

/// The strong entity tag of the picture: its recipe's SHA-256.
std::string etag_of(std::string_view recipe);

/// Recipe: one that has been read.
struct Recipe {
  std::string version;
  Value request;
};

/// Whether a body begins as every PNG file does.
bool is_png(std::string_view body);

/// The text of the recipe in a PNG file. Errors: InputError: malformed as text_in; missing where
/// there is none; limit where it is longer than a body may be.
std::string recipe_text_in(std::string_view png, const Config& config);

/// Reads it within the bounds of JSON bodies: it is one, sent by other means. Errors: InputError:
/// malformed for a text that is no recipe; limit where it is longer than a body may be. Stopped.
Recipe read_recipe(std::string_view text, const Config& config, const std::stop_token& stop = {});

/// Errors: InputError (conflict) at /version for a recipe of another version than this.
void check_version(const Recipe& recipe);

}  // namespace tia::server
