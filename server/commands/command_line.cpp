#include "server/commands/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "core/version.h"

namespace tia::server {

void Command::takes_all() { app_->fallthrough(); }
void Command::hide() { app_->group(""); }
bool Command::is_asked() const { return app_->parsed(); }

void Command::word(const std::string& name, std::string& word, const std::string& about,
                   bool required) {
  app_->add_option(name, word, about)->required(required)->type_name("");
}
void Command::number(const std::string& name, std::uint64_t& number) {
  app_->add_option(name, number)->required();
}
void Command::number(const std::string& name, unsigned& number) {
  app_->add_option(name, number)->required();
}
void Command::words(const std::string& name, std::vector<std::string>& words,
                    const std::string& about) {
  app_->add_option(name, words, about)->required()->type_name("");
}
void Command::flag(const std::string& name, bool& is_given, const std::string& about) {
  app_->add_flag(name, is_given, about);
}
void Command::option(const std::string& name, std::string& value, const std::string& about,
                     bool required) {
  app_->add_option(name, value, about)->required(required)->type_name("");
}
void Command::option(const std::string& name, std::optional<int>& value, const std::string& about) {
  app_->add_option(name, value, about)->type_name("");
}
void Command::option(const std::string& name, double& value, double least, double most,
                     const std::string& about) {
  app_->add_option(name, value, about)->check(CLI::Range(least, most))->type_name("");
}
void Command::option(const std::string& name, const std::function<void(const std::string&)>& take,
                     const std::string& about) {
  app_->add_option_function<std::string>(name, take, about)->type_name("");
}

CommandLine::CommandLine()
    : program_(std::make_unique<CLI::App>("Tia, a ray-tracing render service")),
      settings_(environment_settings()) {
  program_->set_version_flag("--version", "Tia " + version());
  program_->require_subcommand(0, 1);
}

CommandLine::~CommandLine() = default;

Command CommandLine::add_to(const Command& group, const std::string& name, const std::string& about,
                            Action action) {
  const Command command(*group.app_->add_subcommand(name, about));
  commands_.push_back({command, std::move(action)});
  return command;
}

Command CommandLine::add(const std::string& name, const std::string& about, Action action) {
  return add_to(program(), name, about, std::move(action));
}

Command CommandLine::add_group(const std::string& name, const std::string& about) {
  return Command(*program_->add_subcommand(name, about)->fallthrough()->require_subcommand(1));
}

void CommandLine::take_options(Command command) {
  for (const OptionRow& row : option_rows()) {
    const auto take = [this, row](const std::string& text) {
      settings_.push_back({row.name, text, row.flag});
    };
    const std::string standard = row.value.empty() ? "none" : row.value;
    command.option(row.flag, take,
                   row.about + ":\n" + row.allowed + " [" + standard + "], or " + row.variable);
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
      std::ranges::find_if(commands_, [](const Acting& each) { return each.command.is_asked(); });
  (asked != commands_.end() ? asked->action : otherwise_)();
  return status;
}

}  // namespace tia::server
