#include "server/commands/picture_file.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "core/input/json.h"
#include "core/scene/left_out.h"
#include "server/commands/files.h"
#include "server/requests/draw.h"

namespace tia::server {
namespace {

const FormatRow* row_named_by(const std::string& file) {
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

std::string_view format_named_by(const std::string& file, const std::vector<Setting>& parameters) {
  const auto ending = std::filesystem::path(file).extension();
  const bool told =
      std::ranges::any_of(parameters, [](auto& each) { return each.name == "format"; });
  if (const FormatRow* const row = row_named_by(file)) return row->name;
  if (!told && !ending.empty())
    throw std::invalid_argument("option -o: got " + file + ", allowed: " + picture_files() +
                                ", -, or any name with --format");
  return {};
}

Value scene_named(const std::string& scene, const JsonLimits& limits) {
  if (scene.find_first_of("./") == scene.npos) return scene;
  try {
    return parse_json(read_file(scene), limits);
  } catch (const InputError& error) {
    throw std::runtime_error(scene + ": " + error.what());
  }
}

Workshop::Workshop(const Config& config, std::int64_t geometry_bytes)
    : pool_(config.threads),
      geometries_(geometry_bytes),
      account_(config.memory_bytes),
      models_(ModelReader({.memory_bytes = static_cast<std::uint64_t>(config.model_memory_bytes)}),
              {config.max_models_bytes, config.model_limits()}, {account_, long_work_, metrics_},
              nullptr),
      context_{gallery_,   none_kept_,      geometries_, none_pressed_,  pool_,
               long_work_, config.limits(), &models_,    {config.ffmpeg}} {}

// The picture; until it is there a bar is drawn on, and the file written anew, as is wanted.
Picture Workshop::watched(const std::string& file, Plan& plan, const Watching& watching) const {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds between{1000};  // of the bar's own looks at the noise
  ProgressBar bar(plan.options.samples);
  Clock::time_point seen = Clock::now(), written = seen;
  const auto is_due = [&] { return watching.every && Clock::now() - written >= *watching.every; };
  const Onlooker onlooker{
      [&] { return is_due() || (watching.shows_progress && Clock::now() - seen >= between); },
      [&](const SeenPicture& now) {
        const Picture& picture = *now.picture;
        if (watching.shows_progress)
          bar.has_reached(*picture.reached, picture.tells_noise, picture.rays.all());
        if (is_due()) {
          replace_file(file, picture.bytes);
          written = Clock::now();
        }
        seen = Clock::now();
      }};
  if (watching.shows_progress)
    plan.options.spent = [&](std::int64_t rays, std::int64_t) { bar.has_traced(rays); };
  Picture picture = draw(plan, context_, {}, &onlooker);
  if (!watching.shows_progress) return picture;
  if (picture.reached) bar.has_reached(*picture.reached, picture.tells_noise, picture.rays.all());
  bar.end();
  return picture;
}

void Workshop::draw_to(const std::string& file, const PictureRequest& request, bool plain,
                       const Watching& watching) {
  const FormatRow* const named = row_named_by(file);
  if (named != nullptr && named->format != request.format)
    throw std::invalid_argument("--format " + std::string(name_of(request.format)) +
                                " does not go with the file's name " + file);
  Plan plan = plan_of(request, context_, {});
  if (plain) plan.options.scalar = Scalar::narrow;
  if (watching.every && file == "-")
    throw std::invalid_argument("--every needs a file: standard output is written once");
  const Picture picture =
      watching.is_any() ? watched(file, plan, watching) : draw(plan, context_, {});
  tell(picture, plan);
  if (watching.every) replace_file(file, picture.bytes);
  else write_file(file, picture.bytes);
}

}  // namespace tia::server
