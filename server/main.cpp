// The command line: subcommands `serve` (default), `worker`, `render`, `film`, `simulate`, `radio`,
// `scene`, `still`, `model`, `job`, `key` and `sign`. Bad use exits with 2.
#include <CLI/CLI.hpp>
#include <csignal>
#include <iostream>

#include "core/version.h"
#include "server/contract/text_form.h"
#include "server/film_command.h"
#include "server/job_command.h"
#include "server/jobs/farm.h"
#include "server/key_command.h"
#include "server/model_command.h"
#include "server/operation/config.h"
#include "server/picture_file.h"
#include "server/progress.h"
#include "server/radio_command.h"
#include "server/render_command.h"
#include "server/requests/film_request.h"
#include "server/requests/picture_request.h"
#include "server/requests/still_query.h"
#include "server/scene_command.h"
#include "server/serve_command.h"
#include "server/simulate_command.h"
#include "server/still_command.h"
#include "server/stores/model_reader.h"

namespace {

using namespace tia::server;

constexpr int bad_use = 2;

/// Asked: what the command line and the environment ask for.
struct Asked {
  std::vector<Setting> settings = environment_settings(), parameters = {};
  std::string scene, question, file;
  std::vector<std::string> model_files = {};
  Confinement confinement = {};
  bool healthcheck = false, print_config = false, plain = false;
  Watching watching = {};
  JobWishes job = {};
  std::string job_file, join_folder, worker = own_worker_name();
  std::optional<int> part = {};
  std::string key_id = {}, url = {};
  double sign_for_s = 3600;
};

// Every row of the options' table as a flag; what is given goes to `settings`.
void add_options(CLI::App& app, std::vector<Setting>& settings) {
  for (const OptionRow& row : option_rows()) {
    const auto take = [&settings, row](const std::string& text) {
      settings.push_back({row.name, text, row.flag});
    };
    const std::string standard = row.value.empty() ? "none" : row.value;
    app.add_option_function<std::string>(
           row.flag, take,
           row.about + ":\n" + row.allowed + " [" + standard + "], or " + row.variable)
        ->type_name("");
  }
}

// Every parameter of /render but the scene as a flag of `tia render`, of /film of `tia film`, and
// of /still of `tia still`.
struct ParameterFlags {
  CLI::App& app;
  std::vector<Setting>& settings;
  template <class Base>
  void operator()(std::string_view, std::variant<std::string, tia::Scene> Base::*,
                  const tia::Spec&) {}
  template <class Base, class Member>
  void operator()(std::string_view field, Member Base::*, const tia::Spec& spec) {
    const std::string name(field);
    const auto take = [this_settings = &settings, name](const std::string& text) {
      this_settings->push_back({name, text, "--" + name});
    };
    app.add_option_function<std::string>(flag_of(name), take,
                                         spec.about + (": " + TextForm<Member>::allowed(spec)))
        ->type_name("");
  }
};

// Adds the subcommand `serve`, and all its flags to the program itself.
void add_serve(CLI::App& app, Asked& asked) {
  CLI::App* serve = app.add_subcommand("serve", "serve over HTTP (default)");
  for (CLI::App* each : {&app, serve}) {
    each->add_flag("--print-config", asked.print_config,
                   "print every option's value as a file of variables (docker's --env-file), "
                   "and exit");
    add_options(*each, asked.settings);
  }
}

CLI::App* add_worker(CLI::App& app, Asked& asked) {
  CLI::App* worker = app.add_subcommand("worker", "draw parts of the jobs of a farm (TIA_FARM)");
  worker
      ->add_option("--name", asked.worker,
                   "what the others are told it is called [machine and process]")
      ->type_name("");
  add_options(*worker, asked.settings);
  return worker;
}

// Where the picture goes, and how it is traced.
void add_picture(CLI::App& command, Asked& asked) {
  command.add_option("-o,--output", asked.file, picture_files() + ", or - for standard output")
      ->required()
      ->type_name("");
  command.add_flag("--plain", asked.plain,
                   "trace one ray and one thing at a time: the same bytes, to compare with");
}

// The files of a model.
void add_model_files(CLI::App& command, Asked& asked) {
  command
      .add_option("files", asked.model_files,
                  "a GLB, glTF, OBJ, PLY or STL file, and others that it names; what it names "
                  "beside it is found")
      ->required()
      ->type_name("");
}

void add_scene(CLI::App& command, Asked& asked) {
  command
      .add_option("scene", asked.scene,
                  "a gallery scene's name, or a scene file: NAME.json or a path")
      ->required()
      ->type_name("");
}

// Parts of a job in the place of a scene.
void add_job_parts(CLI::App& render, Asked& asked) {
  render
      .add_option("--job", asked.job_file,
                  "a job, as POST /jobs takes it, in the place of a scene: draws the part that "
                  "--part, SLURM_ARRAY_TASK_ID or JOB_COMPLETION_INDEX says into the folder that "
                  "-o names, or, without one, says how many there are")
      ->type_name("");
  render.add_option("--part", asked.part, "the part of --job, from 0")->type_name("");
  render
      .add_option("--join", asked.join_folder,
                  "with --job: puts the parts in this folder together, to the file that -o names")
      ->type_name("");
}

CLI::App* add_render(CLI::App& app, Asked& asked) {
  CLI::App* render = app.add_subcommand("render", "draw one picture to a file")->fallthrough();
  add_scene(*render, asked);
  add_picture(*render, asked);
  add_job_parts(*render, asked);
  render->get_option("scene")->required(false);
  render->get_option("-o")->required(false);
  render->add_flag("--progress", asked.watching.shows_progress,
                   "show a bar with samples, noise and the time left on standard error");
  render
      ->add_option_function<std::string>(
          "--every",
          [&asked](const std::string& text) {
            asked.watching.every = time_from_text("--every", text);
          },
          "write the file anew as often, with what is drawn by then: 5s, 500ms, 2min")
      ->type_name("");
  PictureRequest::fields(ParameterFlags{*render, asked.parameters});
  return render;
}

CLI::App* add_film(CLI::App& app, Asked& asked) {
  CLI::App* film =
      app.add_subcommand("film", "draw an animated scene as a film to a file")->fallthrough();
  add_scene(*film, asked);
  film->add_option("-o,--output", asked.file, film_files() + ", or - for standard output")
      ->required()
      ->type_name("");
  film->add_flag("--progress", asked.watching.shows_progress,
                 "show frames, their rate and the time left on standard error");
  FilmRequest::fields(ParameterFlags{*film, asked.parameters});
  return film;
}

CLI::App* add_simulate(CLI::App& app, Asked& asked) {
  CLI::App* simulate =
      app.add_subcommand("simulate", "put tracks in the place of a scene's physics")->fallthrough();
  simulate
      ->add_option("scene", asked.scene,
                   "a gallery scene's name, or a scene file: NAME.json or a path")
      ->required()
      ->type_name("");
  simulate->add_option("-o,--output", asked.file, "NAME.json, or - for standard output")
      ->required()
      ->type_name("");
  return simulate;
}

CLI::App* add_question(CLI::App& radio, const char* name, const char* about, const char* files,
                       Asked& asked) {
  CLI::App* command = radio.add_subcommand(name, about)->fallthrough();
  add_scene(*command, asked);
  const std::string words = std::string("a file with the parameters of /radio/") + name;
  command->add_option("question", asked.question, words + " but the scene, as JSON")
      ->required()
      ->type_name("");
  command->add_option("-o,--output", asked.file, files)->required()->type_name("");
  return command;
}

/// RadioCommands: what waves are followed for.
struct RadioCommands {
  const CLI::App *paths, *map;
};
RadioCommands add_radio(CLI::App& app, Asked& asked) {
  CLI::App* radio = app.add_subcommand("radio", "follow radio waves in a scene")->fallthrough();
  const CLI::App* paths = add_question(*radio, "paths", "the ways between antennas, as JSON",
                                       "NAME.json, or - for standard output", asked);
  const CLI::App* map = add_question(*radio, "map", "what is received where",
                                     "NAME.png, NAME.pfm, NAME.json, or - for a PNG", asked);
  radio->require_subcommand(1);
  return {paths, map};
}

CLI::App* add_scenes(CLI::App& app, Asked& asked) {
  CLI::App* scenes = app.add_subcommand("scene", "make scenes")->fallthrough();
  CLI::App* buildings =
      scenes->add_subcommand("from-geojson", "blocks of polygons with heights, in metres")
          ->fallthrough();
  buildings->add_option("file", asked.question, "GeoJSON")->required()->type_name("");
  buildings->add_option("-o,--output", asked.file, "NAME.json, or - for standard output")
      ->required()
      ->type_name("");
  scenes->require_subcommand(1);
  return buildings;
}

CLI::App* add_model(CLI::App& app, Asked& asked) {
  CLI::App* model = app.add_subcommand("model", "tell what is in a model's file, as JSON");
  add_model_files(*model, asked);
  return model;
}

CLI::App* add_still(CLI::App& app, Asked& asked) {
  CLI::App* still =
      app.add_subcommand("still", "draw the picture of a model's file")->fallthrough();
  add_model_files(*still, asked);
  add_picture(*still, asked);
  StillParameters::fields(ParameterFlags{*still, asked.parameters});
  return still;
}

CLI::App* add_key(CLI::App& app, Asked& asked) {
  CLI::App* key = app.add_subcommand("key", "make a secret, and its entry for TIA_KEYS_FILE");
  key->add_option("ID", asked.key_id, "what the key is called")->required()->type_name("");
  return key;
}

CLI::App* add_sign(CLI::App& app, Asked& asked) {
  CLI::App* sign = app.add_subcommand("sign", "sign a URL by the first line of TIA_SIGN_FILE");
  sign->fallthrough();
  sign->add_option("URL", asked.url, "a URL, or its path and query")->required()->type_name("");
  sign->add_option("--for", asked.sign_for_s, "for how many seconds it holds [3600]")
      ->check(CLI::Range(1.0, 1e9))
      ->type_name("");
  return sign;
}

/// JobCommands: the subcommands of `tia job`.
struct JobCommands {
  CLI::App *job, *submit, *status, *cancel;
};
JobCommands add_job(CLI::App& app, Asked& asked) {
  CLI::App* job = app.add_subcommand("job", "jobs of a server: submit, status, cancel");
  job->require_subcommand(1);
  job->add_option("--url", asked.job.url, "the server [" + asked.job.url + "]")->type_name("");
  job->fallthrough();
  CLI::App* submit = job->add_subcommand("submit", "send one, as POST /jobs takes it");
  submit->add_option("file", asked.job.file, "a JSON file")->required()->type_name("");
  submit->add_flag("--wait", asked.job.waits, "wait for its end");
  submit
      ->add_option("-o,--output", asked.job.output,
                   "wait, and write the result there; NAME.zip for that of several pictures")
      ->type_name("");
  const auto with_id = [&](const char* name, const char* about) {
    CLI::App* command = job->add_subcommand(name, about);
    command->add_option("id", asked.job.id, "the job's id")->required()->type_name("");
    return command;
  };
  return {job, submit, with_id("status", "say how far it is, as JSON"),
          with_id("cancel", "cancel it, or let its result go")};
}
void run_job(const JobCommands& commands, const Asked& asked) {
  if (commands.submit->parsed()) submit_job(asked.job);
  else if (commands.status->parsed()) tell_job(asked.job);
  else cancel_job(asked.job);
}

void run_render(const Asked& asked, const Config& config) {
  if (asked.job_file.empty()) {
    if (asked.scene.empty()) throw std::invalid_argument("render needs a scene, or --job");
    if (asked.file.empty()) throw std::invalid_argument("render needs --output (-o)");
    return render_to_file(asked.scene, asked.file, asked.parameters, asked.plain, asked.watching,
                          config);
  }
  const std::optional<int> part = asked.part ? asked.part : part_of_environment();
  if (asked.file.empty() && (part || !asked.join_folder.empty()))
    throw std::invalid_argument("render --job needs -o");
  if (!asked.join_folder.empty()) join_job(asked.job_file, asked.join_folder, asked.file, config);
  else draw_job_part(asked.job_file, part, asked.file, config);
}

// What the server starts: nobody else should.
CLI::App* add_read_model(CLI::App& app, Asked& asked) {
  CLI::App* reader = app.add_subcommand("read-model")->group("");
  reader->add_option("memory_bytes", asked.confinement.memory_bytes)->required();
  reader->add_option("cpu_s", asked.confinement.cpu_s)->required();
  return reader;
}

int run(int argc, char** argv) {
  CLI::App app("Tia, a ray-tracing render service");
  Asked asked;
  app.set_version_flag("--version", "Tia " + tia::version());
  app.add_flag("--healthcheck", asked.healthcheck,
               "ask the server on this machine whether it lives");
  add_serve(app, asked);
  const CLI::App* worker = add_worker(app, asked);
  const CLI::App* render = add_render(app, asked);
  const CLI::App* film = add_film(app, asked);
  const CLI::App* simulate = add_simulate(app, asked);
  const RadioCommands radio = add_radio(app, asked);
  const CLI::App* buildings = add_scenes(app, asked);
  const CLI::App* still = add_still(app, asked);
  const CLI::App* model = add_model(app, asked);
  const JobCommands jobs = add_job(app, asked);
  const CLI::App* key = add_key(app, asked);
  const CLI::App* sign = add_sign(app, asked);
  const CLI::App* reader = add_read_model(app, asked);
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_use;
  }

  if (reader->parsed()) answer_as_reader(asked.confinement);
  if (jobs.job->parsed()) {
    run_job(jobs, asked);
    return 0;
  }
  if (model->parsed()) {
    describe_model(asked.model_files);
    return 0;
  }
  if (key->parsed()) {
    print_new_key(asked.key_id);
    return 0;
  }
  const Config config = read_config(asked.settings);
  if (asked.healthcheck) return is_healthy(config) ? 0 : 1;
  for (const std::string& warning : unknown_variables()) std::cerr << "tia: " << warning << '\n';
  if (asked.print_config) std::cout << env_file(config) << std::flush;
  else if (render->parsed()) run_render(asked, config);
  else if (film->parsed())
    film_to_file(asked.scene, asked.file, asked.parameters, asked.watching.shows_progress, config);
  else if (simulate->parsed()) simulate_to_file(asked.scene, asked.file, config);
  else if (radio.paths->parsed())
    radio_paths_to_file(asked.scene, asked.question, asked.file, config);
  else if (radio.map->parsed()) radio_map_to_file(asked.scene, asked.question, asked.file, config);
  else if (buildings->parsed()) footprints_to_file(asked.question, asked.file);
  else if (still->parsed())
    still_to_file(asked.model_files, asked.file, asked.parameters, asked.plain, config);
  else if (sign->parsed()) print_signed_url(asked.url, asked.sign_for_s, config);
  else if (worker->parsed()) work(config, asked.worker);
  else serve(config);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow: the write's error is enough
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "tia: " << error.what() << '\n';
    return bad_use;
  }
}
