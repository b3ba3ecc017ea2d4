#include "server/requests/recipe.h"

#include "core/film/png_chunk.h"
#include "core/film/png_text.h"
#include "core/input/json.h"
#include "core/version.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

/// Visitor: copies all of a scene but what there may be a lot of.
struct SmallFields {
  const Scene& from;
  Scene& to;
  template <class Member>
  void operator()(std::string_view, Member Scene::*member, const Spec&) {
    if constexpr (!std::is_same_v<Member, decltype(Scene::objects)> &&
                  !std::is_same_v<Member, decltype(Scene::materials)>)
      to.*member = from.*member;
  }
};

// Keys change no byte of the picture: they are told for who goes on from it, unless they are long.
bool has_long_keys(const Scene& scene) {
  std::size_t left = most_told_bytes;
  for (const auto& [name, binding] : scene.keys) {
    const auto* patch = std::get_if<SharedValue>(&binding);
    const std::size_t bytes =
        name.size() + (patch != nullptr ? start_of_json(**patch, left).size() : 64);
    if (bytes >= left) return true;
    left -= bytes;
  }
  return false;
}

Value told_scene(const Plan& plan) {
  const KnownScene& from = told_scene_of(plan);
  const ObjectsName& objects = from.objects;
  Scene told;
  Scene::fields(SmallFields{*from, told});
  told.options = plan.in_effect;
  if (has_long_keys(told)) told.keys.clear();
  const bool small = objects.bytes <= most_told_bytes;
  if (small) {
    told.materials = from->materials;
    told.objects = from->objects;
  }
  Value scene = write_value(told);
  if (!small) scene.as<Value::Object>()->emplace_back("objects", "sha256:" + hex(objects.digest));
  return scene;
}

// In the order of the list, which changes no byte.
Value told_layers(const Plan& plan) {
  Value::Array names;
  plan.layers.for_each([&](const LayerRow& row) { names.emplace_back(row.text); });
  return names;
}

void refuse_untold(const Value& request) {
  const auto* members = request.as<Value::Object>();
  const Value* scene = members != nullptr ? find(*members, "scene") : nullptr;
  const auto* parts = scene != nullptr ? scene->as<Value::Object>() : nullptr;
  const Value* objects = parts != nullptr ? find(*parts, "objects") : nullptr;
  if (objects != nullptr && objects->as<std::string>() != nullptr)
    throw InputError({FaultKind::limit, "/scene/objects", excerpt(*objects),
                      "the picture of a scene whose objects hold at most " +
                          std::to_string(most_told_bytes) +
                          " bytes, for then its recipe tells them"});
}

// A request's, and a place around it.
JsonLimits limits_of(const Config& config) {
  JsonLimits limits = config.json_limits();
  limits.depth += 1;
  limits.values += 3;
  return limits;
}

Recipe recipe_of(Value&& value) {
  auto* members = value.as<Value::Object>();
  const Value* version = members != nullptr ? find(*members, "version") : nullptr;
  const Value* request = members != nullptr ? find(*members, "request") : nullptr;
  if (version == nullptr || request == nullptr || members->size() != 2 ||
      version->as<std::string>() == nullptr || request->as<Value::Object>() == nullptr)
    throw InputError({FaultKind::malformed, "", excerpt(value), "the recipe of a picture of Tia"});
  refuse_untold(*request);
  Recipe recipe;
  for (auto& [name, is] : *members) {
    if (name == "version") recipe.version = std::move(*is.as<std::string>());
    else recipe.request = std::move(is);
  }
  return recipe;
}

[[noreturn]] void too_long(std::size_t most) {
  throw InputError({FaultKind::limit, "", Value("a file whose recipe is longer"),
                    "a recipe of at most " + std::to_string(most) +
                        " bytes when it is unpacked (option TIA_MAX_BODY_BYTES)"});
}

}  // namespace

std::string recipe_of(const PictureRequest& asked, const Plan& plan) {
  const PictureRequest usual;
  Value::Object request{{"scene", told_scene(plan)}};
  if (plan.exposure.blurs() && plan.exposure.seconds > 0)
    request.emplace_back("time", plan.exposure.seconds);
  if (asked.width != usual.width) request.emplace_back("width", asked.width);
  if (asked.height != usual.height) request.emplace_back("height", asked.height);
  if (!(plan.window == plan.whole)) request.emplace_back("crop", write_value(asked.crop));
  if (asked.denoise) request.emplace_back("denoise", true);
  if (plan.options.gaze) {
    request.emplace_back("gaze", write_value(asked.gaze));
    const Acuity& acuity = plan.options.gaze->acuity;  // which keeps to gaze_rays
    if (!(acuity == Acuity{})) request.emplace_back("acuity", write_value(acuity));
  }
  if (asked.format != usual.format) request.emplace_back("format", name_of(asked.format));
  if (asked.depth_range) request.emplace_back("depth_range", write_value(*asked.depth_range));
  if (plan.format == Format::exr) {
    if (!(plan.layers == usual.layers_in_effect())) request.emplace_back("aov", told_layers(plan));
    if (asked.depth == 32) request.emplace_back("depth", write_value(asked.depth));
  }
  return to_json(Value::Object{{"request", std::move(request)}, {"version", full_version()}});
}

std::string rounds_name_of(const PictureRequest& asked, const Plan& plan) {
  if (!row_of(plan.options.integrator).is_chance() || plan.options.threshold > 0 ||
      plan.options.denoise || plan.options.gaze || plan.has_several())
    return "";
  Plan any = plan;
  any.in_effect.samples = std::nullopt;
  return "rounds " + sha256_hex(recipe_of(asked, any));
}

std::string etag_of(std::string_view recipe) { return '"' + sha256_hex(recipe) + '"'; }

bool is_png(std::string_view body) { return body.starts_with(png_signature); }

// A few bytes of a file may unpack to millions.
std::string recipe_text_in(std::string_view png, const Config& config) {
  const auto most = static_cast<std::size_t>(config.max_body_bytes);
  try {
    if (auto text = text_in(png, recipe_keyword, most)) return std::move(*text);
  } catch (const InputError& error) {
    if (error.faults().front().kind != FaultKind::limit) throw;
    too_long(most);
  }
  throw InputError({FaultKind::missing, "", std::nullopt,
                    "a PNG file as this server has sent it: its recipe is in a text chunk, which "
                    "some programs leave out when they save a picture"});
}

Recipe read_recipe(std::string_view text, const Config& config, const std::stop_token& stop) {
  Recipe recipe = recipe_of(parse_json(text, limits_of(config), stop));
  // It is told again in canonical form, in which 1e20 has 21 digits.
  const auto most = static_cast<std::size_t>(config.max_body_bytes);
  if (start_of_json(recipe.request, most).size() > most) too_long(most);
  return recipe;
}

void check_version(const Recipe& recipe) {
  if (recipe.version != full_version())
    throw InputError({FaultKind::conflict, "/version", Value(recipe.version),
                      full_version() + ", for only the version that drew a picture draws it again; "
                                       "what another asks for is told by POST /verify"});
}

}  // namespace tia::server
