// The command line: subcommands `serve` (default) and `render`. Bad use exits with 2.
#include <CLI/CLI.hpp>
#include <iostream>

#include "core/version.h"
#include "server/config.h"
#include "server/picture.h"
#include "server/render_command.h"
#include "server/serve_command.h"
#include "server/text_form.h"

namespace {

using namespace tia::server;

constexpr int bad_use = 2;

// Every row of the options' table as a flag; what is given goes to `settings`.
void add_options(CLI::App& app, std::vector<Setting>& settings) {
  for (const OptionRow& row : option_rows()) {
    const auto take = [&settings, row](const std::string& text) {
      settings.push_back({row.name, text, row.flag});
    };
    app.add_option_function<std::string>(
           row.flag, take,
           row.about + ": " + row.allowed + " [" + row.default_text + "], or " + row.variable)
        ->type_name("");
  }
}

// Every parameter of /render but the scene as a flag of `tia render`.
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

int run(int argc, char** argv) {
  CLI::App app("Tia, a ray-tracing render service");
  std::vector<Setting> settings = environment_settings(), parameters;
  std::string scene, file;
  bool healthcheck = false;
  app.set_version_flag("--version", "Tia " + tia::version());
  app.add_flag("--healthcheck", healthcheck, "ask the server on this machine whether it lives");
  add_options(app, settings);
  add_options(*app.add_subcommand("serve", "serve over HTTP (default)"), settings);
  CLI::App* render = app.add_subcommand("render", "draw one picture to a file")->fallthrough();
  render->add_option("scene", scene, "a gallery scene's name, or a scene file: NAME.json or a path")
      ->required()
      ->type_name("");
  render->add_option("-o,--output", file, "NAME.png, NAME.pfm, or - for standard output")
      ->required()
      ->type_name("");
  PictureRequest::fields(ParameterFlags{*render, parameters});
  app.require_subcommand(0, 1);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_use;
  }

  const Config config = read_config(settings);
  if (healthcheck) return is_healthy(config) ? 0 : 1;
  if (render->parsed()) render_to_file(scene, file, parameters, config);
  else serve(config);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "tia: " << error.what() << '\n';
    return bad_use;
  }
}
