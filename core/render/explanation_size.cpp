#include "core/render/explanation_size.h"

#include "core/integrators/path_record.h"

namespace tia {
namespace {

// Canonical text: the longest number is -2.2250738585072014e-308, one more for a comma.
constexpr std::size_t number = 25, three = 3 * number + 2;

std::size_t text_bytes(std::string_view text) { return to_json(Value(text)).size(); }

// Names and quotes of members, brackets, commas; `true` and short words such as a type's.
constexpr std::size_t hit_frame = 120, bracket_frame = 80, ray_frame = 140, term_frame = 70,
                      light_frame = 90, id_member = 32, object_frame = 80, note_frame = 30;
constexpr std::size_t path_frame = 120, vertex_frame = 80, path_light_frame = 90, asked_frame = 130,
                      group_frame = 80;

// Of the member that tells which copy it is.
std::size_t copy_bytes(const World& world, int primitive) {
  constexpr std::size_t member = 20, group = 30;  // "blocker_copy":[], and [16777215, three times
  const Geometry& geometry = world.geometry_of(primitive);
  const std::size_t groups =
      instances_around(geometry, geometry.primitive(primitive).space, 0).size();
  return groups == 0 ? 0 : member + groups * group;
}

}  // namespace

void ExplanationSize::take(std::size_t bytes, const char* pointer, const char* remedy) {
  bytes_ += bytes;
  if (bytes_ > longest_explanation)
    throw InputError(
        {FaultKind::limit, pointer, std::nullopt,
         "an explanation of at most " + std::to_string(longest_explanation) + " bytes; " + remedy});
}

std::size_t ExplanationSize::naming(int primitive, const World& world) {
  if (primitive < 0) return std::string_view("null").size();
  return naming_object(world.primitive(primitive).object, copy_bytes(world, primitive));
}

std::size_t ExplanationSize::naming_object(int object, std::size_t copy_bytes) {
  const std::string& name = labels_[static_cast<std::size_t>(object)].name;
  const std::size_t bytes = text_bytes(name) + copy_bytes;
  if (!objects_.insert(object).second) return bytes + id_member;
  constexpr std::size_t longest_pointer = 512;  // (Fault)
  return 2 * bytes + id_member + object_frame + longest_pointer;
}

void ExplanationSize::hit(const Meeting& at) {
  std::size_t bytes = hit_frame + number + 2 * three + 2 * number + naming(at.primitive);
  if (at.bracket) bytes += bracket_frame + 3 * number + text_bytes(at.bracket->how);
  take(bytes, "", "this ray crosses too many surfaces for one");
}

void ExplanationSize::ray(const Hit<float>& hit) {
  const std::size_t bytes = ray_frame + 6 * three + number +
                            naming(hit.t < infinity ? static_cast<int>(hit.primitive) : -1);
  take(bytes, "/max_depth", "a lower max_depth makes fewer mirrored and refracted rays");
}

void ExplanationSize::term(TermName, const LightRecord& record) {
  std::size_t bytes = term_frame + number + three;
  if (record.light >= 0) {
    const WorldLight& light = world_.lights[static_cast<std::size_t>(record.light)];
    bytes += light_frame + 4 * number + three;
    bytes += light.primitive >= 0 ? naming(light.primitive) : text_bytes(light.name);
    if (record.blocker) bytes += naming(*record.blocker);
  }
  take(bytes, "/max_depth", "fewer lights, or a lower max_depth, make fewer terms");
}

void ExplanationSize::take_of_path(std::size_t bytes) {
  take(bytes, "/paths", "fewer paths, or a lower max_depth, make less to tell");
}

void ExplanationSize::path(const PathRecord& path, const World& world) {
  take_of_path(path_frame + three + 4 * number);
  for (const PathVertex& vertex : path.vertices) {
    const bool hit = vertex.hit.t < infinity;
    const int own = hit ? static_cast<int>(vertex.hit.primitive) : -1;
    std::size_t bytes = vertex_frame + 3 * three;
    if (hit) bytes += vertex_frame + 2 * three + number + naming(own, world);
    if (vertex.event) bytes += vertex_frame + 2 * three + 2 * number;
    for (const GatheredLight& each : vertex.lights) {
      const int all = world.path_lights.size();
      const int primitive = each.light == GatheredLight::own_surface ? own
                            : each.light >= 0 && each.light < all
                                ? world.path_lights[each.light].primitive
                                : -1;
      constexpr std::size_t pointer = 40;  // of one of the scene's lights
      bytes +=
          path_light_frame + three + number + (primitive < 0 ? pointer : naming(primitive, world));
      if (each.asked) bytes += asked_frame + 3 * three + 4 * number;
    }
    take_of_path(bytes);
  }
}

void ExplanationSize::path_group() { take_of_path(group_frame + 2 * three + 2 * number); }

void ExplanationSize::path_surface(int object) {
  take_of_path(group_frame + 2 * three + 2 * number + naming_object(object, 0));
}

void ExplanationSize::note(std::string_view pointer, std::string_view about) {
  take(note_frame + text_bytes(pointer) + text_bytes(about), "", "there is much to note of it");
}

}  // namespace tia
