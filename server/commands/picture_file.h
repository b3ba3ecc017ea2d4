// Pictures in files, without a server: what `tia render` and `tia still` share.
#pragma once

#include <string>
#include <vector>

#include "server/commands/progress.h"
#include "server/contract/text_form.h"
#include "server/operation/config.h"
#include "server/operation/cost_memory.h"
#include "server/operation/metrics.h"
#include "server/requests/picture_request.h"
#include "server/requests/plan.h"
#include "server/requests/render_context.h"
#include "server/stores/picture.h"

namespace tia::server {

/// The files whose ending names their format: "NAME.png, NAME.pfm" and so on.
std::string picture_files();

/// The name of the format that a file's ending names; none where it names none.
/// Errors: std::invalid_argument for an ending that names no format, unless one is told.
std::string_view format_named_by(const std::string& file, const std::vector<Setting>& parameters);

/// A scene of the command line: a path or a name with an ending is a file, a bare word a scene of
/// the gallery. Errors: std::runtime_error naming the file.
Value scene_named(const std::string& scene, const JsonLimits& limits);

/// What is asked for as JSON: what is there already, then the parameters by name.
template <class Request>
Value asked_by(Value::Object asked, const std::vector<Setting>& parameters) {
  for (const Setting& each : parameters) {
    std::erase_if(asked, [&](const auto& member) { return member.first == each.name; });
    asked.emplace_back(each.name, field_from_text<Request>(each.name, each.text));
  }
  return asked;
}

/// Workshop: what a picture needs of its host where there is one to draw and no server.
class Workshop {
 public:
  /// `geometry_bytes`: for compiled scenes that pictures share, where there is more than one.
  explicit Workshop(const Config& config, std::int64_t geometry_bytes = 0);

  /// Draws it to a file (or "-", standard output) and says on standard error what it is not.
  /// `plain`: one ray and one thing at a time, which is slow and gives the same bytes; `watching`:
  /// what is seen of it until then, which changes none either.
  /// Errors: InputError; std::invalid_argument where the file's name says another format;
  /// std::runtime_error for files.
  void draw_to(const std::string& file, const PictureRequest& request, bool plain,
               const Watching& watching = {});

  ModelStore& models() { return models_; }
  const RenderContext& context() const { return context_; }

 private:
  Picture watched(const std::string& file, Plan& plan, const Watching& watching) const;

  const Gallery gallery_;
  Pool pool_;
  SceneStore none_kept_{0};
  GeometryStore geometries_;
  MemoryAccount account_;
  Admission alone_{{}};
  LongWork long_work_{alone_, pool_};
  PressedScenes none_pressed_{0, long_work_, account_};
  Metrics metrics_;
  ModelStore models_;
  const RenderContext context_;
};

}  // namespace tia::server
