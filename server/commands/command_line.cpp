#include "server/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "core/version.h"

namespace tia::server {

CommandLine::CommandLine()
    : program_(std::make_unique<CLI::App>("Tia, a ray-tracing render service")),
      settings_(environment_settings()) {
  program_->set_version_flag("--version", "Tia " + version());
  program_->require_subcommand(0, 1);
}

CommandLine::~CommandLine() = default;

CLI::App& CommandLine::add_to(CLI::App& group, const std::string& name, const std::string& about,
                              Action action) {
  CLI::App* const command = group.add_subcommand(name, about);
  commands_.push_back({command, std::move(action)});
  return *command;
}

CLI::App& CommandLine::add(const std::string& name, const std::string& about, Action action) {
  return add_to(program(), name, about, std::move(action));
}

CLI::App& CommandLine::add_group(const std::string& name, const std::string& about) {
  return *program_->add_subcommand(name, about)->fallthrough()->require_subcommand(1);
}

void CommandLine::take_options(CLI::App& command) {
  for (const OptionRow& row : option_rows()) {
    const auto take = [this, row](const std::string& text) {
      settings_.push_back({row.name, text, row.flag});
    };
    const std::string standard = row.value.empty() ? "none" : row.value;
    command
        .add_option_function<std::string>(
            row.flag, take,
            row.about + ":\n" + row.allowed + " [" + standard + "], or " + row.variable)
        ->type_name("");
  }
}

Config CommandLine::config() const {
  Config config = read_config(settings_);
  for (const std::string& warning : unknown_variables()) std::cerr << "tia: " << warning << '\n';
  return config;
}

int CommandLine::run(int argc, char** argv) {
  try {
    program_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program_->exit(error) == 0 ? 0 : bad_use;
  }
  const auto asked =
      std::ranges::find_if(commands_, [](const Command& each) { return each.app->parsed(); });
  (asked != commands_.end() ? asked->action : otherwise_)();
  return status;
}

}  // namespace tia::server
