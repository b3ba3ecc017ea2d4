// The program's command line, to which each command adds itself.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "server/operation/config.h"

namespace CLI {
class App;
}

namespace tia::server {

/// CommandLine: flags and subcommands, and what they do once all have been read.
class CommandLine {
 public:
  using Action = std::function<void()>;

  CommandLine();
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  /// The program itself; what it does where no subcommand is given; a subcommand of it; one that
  /// does nothing alone, and a subcommand of that. What takes the server's options must fall
  /// through to the program, as groups and their subcommands do.
  CLI::App& program() { return *program_; }
  void otherwise(Action action) { otherwise_ = std::move(action); }
  CLI::App& add(const std::string& name, const std::string& about, Action action);
  CLI::App& add_group(const std::string& name, const std::string& about);
  CLI::App& add_to(CLI::App& group, const std::string& name, const std::string& about,
                   Action action);

  /// What a command is asked, which lives as long as its actions.
  template <class Asked>
  Asked& keep() {
    auto asked = std::make_shared<Asked>();
    kept_.push_back(asked);
    return *asked;
  }

  /// Takes the server's options as flags of a command, too.
  void take_options(CLI::App& command);
  /// The server's options, of flags and environment. Tells on standard error of variables that
  /// are none. Errors: std::invalid_argument naming an option.
  Config config() const;

  /// Reads the command line and does what it says. Returns the exit status.
  /// Errors: those of the action.
  int run(int argc, char** argv);

  static constexpr int bad_use = 2;
  int status = 0;  ///< to exit with, if not 0 although all went well

 private:
  struct Command {
    const CLI::App* app;
    Action action;
  };
  std::unique_ptr<CLI::App> program_;
  std::vector<Setting> settings_;
  std::vector<std::shared_ptr<void>> kept_;
  std::vector<Command> commands_;
  Action otherwise_;
};

}  // namespace tia::server
