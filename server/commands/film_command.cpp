// `tia film SCENE -o FILE`: the same films without a server.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "server/commands/commands.h"
#include "server/commands/files.h"
#include "server/commands/flags.h"
#include "server/commands/picture_file.h"
#include "server/requests/shooting.h"

namespace tia::server {
namespace {

struct FilmAsked {
  std::string scene, file;
  std::vector<Setting> parameters = {};
  bool shows_progress = false;  // frames, rate and the time left, on standard error
};

// "NAME.apng, NAME.zip" and so on: the files whose ending names their format.
std::string film_files() {
  std::string files;
  for (const FilmFormatRow& row : film_formats)
    files.append(files.empty() ? "NAME." : ", NAME.").append(row.name);
  return files;
}

const FilmFormatRow* film_row_named_by(const std::string& file) {
  const auto* row = std::ranges::find_if(
      film_formats, [&](auto& each) { return file.ends_with(std::string(".").append(each.name)); });
  return row != film_formats.end() ? row : nullptr;
}

// Errors: std::invalid_argument where neither the file's name nor a parameter names a format, or
// both do and differ.
std::string_view film_format_named_by(const std::string& file,
                                      const std::vector<Setting>& parameters) {
  const auto told = std::ranges::find(parameters, "format", &Setting::name);
  const FilmFormatRow* const row = film_row_named_by(file);
  if (told == parameters.end() && row == nullptr && file != "-")
    throw std::invalid_argument("option -o: got " + file + ", allowed: " + film_files() +
                                ", -, or any name with --format");
  if (told != parameters.end() && row != nullptr && told->text != row->name)
    throw std::invalid_argument("--format " + told->text + " does not go with the file's name " +
                                file);
  return row != nullptr ? row->name : std::string_view();
}

/// FrameCount: one line on standard error that is written over.
class FrameCount {
 public:
  explicit FrameCount(int frames) : frames_(frames) {}
  void has_drawn(int frames) const {
    const std::chrono::duration<double> taken = Clock::now() - start_;
    char text[96];
    const double rate = frames / std::max(taken.count(), 1e-9);
    std::snprintf(text, sizeof text, "\rframe %d of %d, %.1f frames/s, %.0f s left", frames,
                  frames_, rate, (frames_ - frames) / rate);
    std::cerr << text << "\x1b[K" << std::flush;
    if (frames == frames_) std::cerr << std::endl;
  }

 private:
  using Clock = std::chrono::steady_clock;
  const int frames_;
  const Clock::time_point start_ = Clock::now();
};

// To a file (or "-", standard output), which is there once it is whole.
void film_to_file(const FilmAsked& by, const Config& config) {
  const std::string_view format = film_format_named_by(by.file, by.parameters);
  Value::Object asked{{"scene", scene_named(by.scene, config.json_limits())}};
  if (!format.empty()) asked.emplace_back("format", format);
  auto request =
      read_described<FilmRequest>(asked_by<FilmRequest>(std::move(asked), by.parameters));
  const Workshop workshop(config, config.max_geometry_bytes);
  const FilmPlan film = film_plan_of(request, workshop.context(), {});
  if (!film.moves) std::cerr << "tia: the scene does not move: the film is one frame\n";
  const FrameCount count(film.frames);
  FileToBe to(by.file);
  const Crew crew{[&](FilmFrames& frames, Plan& plan, const Shot& shot) {
                    auto picture =
                        std::make_shared<const Picture>(frames.draw(plan, workshop.context(), {}));
                    if (by.shows_progress) count.has_drawn(shot.first + shot.frames);
                    return picture;
                  },
                  [](const std::function<void()>& work) { work(); },
                  [&](std::string_view piece) { to.append(piece); }};
  shoot(request, film, workshop.context(), {}, crew);
  to.finish();
}

}  // namespace

void add_film(CommandLine& line) {
  auto& asked = line.keep<FilmAsked>();
  Command film = line.add("film", "draw an animated scene as a film to a file",
                          [&] { film_to_file(asked, line.config()); });
  film.takes_all();
  add_scene(film, asked.scene);
  add_output(film, asked.file, film_files() + ", or - for standard output");
  film.flag("--progress", asked.shows_progress,
            "show frames, their rate and the time left on standard error");
  FilmRequest::fields(ParameterFlags{film, asked.parameters});
}

}  // namespace tia::server
