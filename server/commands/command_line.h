// The program's command line, to which each command adds itself.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "server/operation/config.h"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace tia::server {

/// Command: the program or one of its subcommands, and what it takes. What is given is put into
/// the variables while the command line is read.
class Command {
 public:
  explicit Command(CLI::App& app) : app_(&app) {}

  /// Takes what the program takes, too.
  void takes_all();
  /// Is not told of by --help.
  void hide();
  bool is_asked() const;

  /// A word without a dash.
  void word(const std::string& name, std::string& word, const std::string& about,
            bool required = true);
  void number(const std::string& name, std::uint64_t& number);
  void number(const std::string& name, unsigned& number);
  /// All the other words, one at least.
  void words(const std::string& name, std::vector<std::string>& words, const std::string& about);
  /// A word that begins with a dash, and one with a value behind it.
  void flag(const std::string& name, bool& is_given, const std::string& about);
  void option(const std::string& name, std::string& value, const std::string& about,
              bool required = false);
  void option(const std::string& name, std::optional<int>& value, const std::string& about);
  void option(const std::string& name, double& value, double least, double most,
              const std::string& about);
  /// `take` may throw.
  void option(const std::string& name, const std::function<void(const std::string&)>& take,
              const std::string& about);

 private:
  friend class CommandLine;
  CLI::App* app_;
};

/// CommandLine: the program and its commands, and what they do once all has been read.
class CommandLine {
 public:
  using Action = std::function<void()>;

  CommandLine();
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Command program() { return Command(*program_); }
  /// What the program does where no subcommand is given.
  void otherwise(Action action) { otherwise_ = std::move(action); }
  Command add(const std::string& name, const std::string& about, Action action);
  /// One that does nothing alone, and takes what the program takes, as its subcommands do.
  Command add_group(const std::string& name, const std::string& about);
  Command add_to(const Command& group, const std::string& name, const std::string& about,
                 Action action);

  /// What a command is asked, which lives as long as its actions.
  template <class Asked>
  Asked& keep() {
    auto asked = std::make_shared<Asked>();
    kept_.push_back(asked);
    return *asked;
  }

  /// Has a command take the server's options.
  void take_options(Command command);
  /// The server's options, of flags and environment. Tells on standard error of variables that
  /// are none. Errors: std::invalid_argument naming an option.
  Config config() const;

  /// Reads the command line and does what it says. Returns the exit status.
  /// Errors: those of the action.
  int run(int argc, char** argv);

  static constexpr int bad_use = 2;
  int status = 0;  ///< to exit with, if not 0 although all went well

 private:
  struct Acting {
    Command command;
    Action action;
  };
  std::unique_ptr<CLI::App> program_;
  std::vector<Setting> settings_;
  std::vector<std::shared_ptr<void>> kept_;
  std::vector<Acting> commands_;
  Action otherwise_;
};

}  // namespace tia::server
