#include "server/render_command.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "core/scene/left_out.h"
#include "server/contract/text_form.h"
#include "server/files.h"
#include "server/requests/draw.h"

namespace tia::server {
namespace {

// A path or a name with an ending is a file, a bare word a scene of the gallery.
Value scene_named(const std::string& scene, const JsonLimits& limits) {
  if (scene.find_first_of("./") == scene.npos) return scene;
  try {
    return parse_json(read_file(scene), limits);
  } catch (const InputError& error) {
    throw std::runtime_error(scene + ": " + error.what());
  }
}

// The format that a file's ending names; none where it names none.
const FormatRow* format_named_by(const std::string& file) {
  const auto* row = std::ranges::find_if(
      formats, [&](auto& each) { return file.ends_with(std::string(".").append(each.name)); });
  return row != formats.end() ? row : nullptr;
}

// What the picture is not, on standard error: what a server tells in headers and in its log.
void tell(const Picture& picture, const Plan& plan) {
  const auto tell_of = [](std::size_t count, const char* what) {
    if (count > 0) std::cerr << "tia: " << count << what << '\n';
  };
  tell_of(picture.degenerate, " triangles without area are ignored");
  tell_of(picture.unasked, " luminous objects are met by chance alone");
  tell_of(static_cast<std::size_t>(picture.rays.cut), " paths are cut by max_depth");
  if (plan.in_effect.clamp) std::cerr << "tia: /options/clamp: bright samples may be darkened\n";
  for (const auto& [pointer, about] : left_out_by(plan.in_effect.integrator, *plan.scene))
    std::cerr << "tia: " << pointer << " is ignored: " << about << '\n';
}

}  // namespace

std::string picture_files() {
  std::string files;
  for (const FormatRow& row : formats)
    files.append(files.empty() ? "NAME." : ", NAME.").append(row.name);
  return files;
}

void render_to_file(const std::string& scene, const std::string& file,
                    const std::vector<Setting>& parameters, bool plain, const Config& config) {
  const auto ending = std::filesystem::path(file).extension();
  const bool told =
      std::ranges::any_of(parameters, [](auto& each) { return each.name == "format"; });
  const FormatRow* const named = format_named_by(file);
  if (!told && !ending.empty() && named == nullptr)
    throw std::invalid_argument("option -o: got " + file + ", allowed: " + picture_files() +
                                ", -, or any name with --format");
  Value::Object asked;
  asked.emplace_back("scene", scene_named(scene, config.json_limits()));
  if (named != nullptr) asked.emplace_back("format", named->name);
  for (const Setting& each : parameters) {
    std::erase_if(asked, [&](const auto& member) { return member.first == each.name; });
    asked.emplace_back(each.name, field_from_text<PictureRequest>(each.name, each.text));
  }
  const Gallery gallery;
  Pool pool(config.threads);
  SceneStore none_kept(0);
  GeometryStore none_shared(0);  // there is one picture to draw
  MemoryAccount account(config.memory_bytes);
  Admission alone({});
  LongWork long_work(alone, pool);
  PressedScenes none_pressed(0, long_work, account);
  const RenderContext context{gallery, none_kept, none_shared,    none_pressed,
                              pool,    long_work, config.limits()};
  const auto request = read_described<PictureRequest>(asked);
  if (named != nullptr && named->format != request.format)
    throw std::invalid_argument("--format " + std::string(name_of(request.format)) +
                                " does not go with the file's name " + file);
  Plan plan = plan_of(request, context, {});
  if (plain) plan.options.scalar = Scalar::narrow;
  const Picture picture = draw(plan, context, {});
  tell(picture, plan);
  write_file(file, picture.bytes);
}

}  // namespace tia::server
