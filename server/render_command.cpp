#include "server/render_command.h"

#include "server/picture_file.h"

namespace tia::server {
void render_to_file(const std::string& scene, const std::string& file,
                    const std::vector<Setting>& parameters, bool plain, const Watching& watching,
                    const Config& config) {
  const std::string_view format = format_named_by(file, parameters);
  Value::Object asked;
  asked.emplace_back("scene", scene_named(scene, config.json_limits()));
  if (!format.empty()) asked.emplace_back("format", format);
  const auto request =
      read_described<PictureRequest>(asked_by<PictureRequest>(std::move(asked), parameters));
  Workshop(config).draw_to(file, request, plain, watching);
}

}  // namespace tia::server
