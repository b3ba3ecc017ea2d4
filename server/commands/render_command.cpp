// `tia render SCENE -o FILE`: the same pictures without a server; or parts of a job.
#include <stdexcept>

#include "server/commands/commands.h"
#include "server/commands/flags.h"
#include "server/commands/job_parts.h"
#include "server/commands/picture_file.h"

namespace tia::server {
namespace {

struct RenderAsked {
  std::string scene, file;
  std::vector<Setting> parameters = {};
  bool plain = false;
  Watching watching = {};
  std::string job_file, join_folder;
  std::optional<int> part = {};
};

// A gallery scene or a scene file to a file (or "-", standard output).
void render_scene(const RenderAsked& asked, const Config& config) {
  if (asked.scene.empty()) throw std::invalid_argument("render needs a scene, or --job");
  if (asked.file.empty()) throw std::invalid_argument("render needs --output (-o)");
  const std::string_view format = format_named_by(asked.file, asked.parameters);
  Value::Object members;
  members.emplace_back("scene", scene_named(asked.scene, config.json_limits()));
  if (!format.empty()) members.emplace_back("format", format);
  const auto request = read_described<PictureRequest>(
      asked_by<PictureRequest>(std::move(members), asked.parameters));
  Workshop(config).draw_to(asked.file, request, asked.plain, asked.watching);
}

void render_job(const RenderAsked& asked, const Config& config) {
  const std::optional<int> part = asked.part ? asked.part : part_of_environment();
  if (asked.file.empty() && (part || !asked.join_folder.empty()))
    throw std::invalid_argument("render --job needs -o");
  if (!asked.join_folder.empty()) join_job(asked.job_file, asked.join_folder, asked.file, config);
  else draw_job_part(asked.job_file, part, asked.file, config);
}

// Parts of a job in the place of a scene.
void add_job_parts(Command& render, RenderAsked& asked) {
  render.option("--job", asked.job_file,
                "a job, as POST /jobs takes it, in the place of a scene: draws the part that "
                "--part, SLURM_ARRAY_TASK_ID or JOB_COMPLETION_INDEX says into the folder that "
                "-o names, or, without one, says how many there are");
  render.option("--part", asked.part, "the part of --job, from 0");
  render.option("--join", asked.join_folder,
                "with --job: puts the parts in this folder together, to the file that -o names");
}

void add_watching(Command& render, Watching& watching) {
  render.flag("--progress", watching.shows_progress,
              "show a bar with samples, noise and the time left on standard error");
  const auto take_every = [&watching](const std::string& text) {
    watching.every = time_from_text("--every", text);
  };
  render.option("--every", take_every,
                "write the file anew as often, with what is drawn by then: 5s, 500ms, 2min");
}

}  // namespace

void add_render(CommandLine& line) {
  auto& asked = line.keep<RenderAsked>();
  Command render = line.add("render", "draw one picture to a file", [&] {
    const Config config = line.config();
    if (asked.job_file.empty()) render_scene(asked, config);
    else render_job(asked, config);
  });
  render.takes_all();
  add_scene(render, asked.scene, false);
  add_output(render, asked.file, picture_files() + ", or - for standard output", false);
  add_plain(render, asked.plain);
  add_job_parts(render, asked);
  add_watching(render, asked.watching);
  PictureRequest::fields(ParameterFlags{render, asked.parameters});
}

}  // namespace tia::server
