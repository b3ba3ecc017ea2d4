// The program itself, as a process: started, read, signalled and waited for, always with a
// deadline.
#pragma once

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/server/socket_support.h"

namespace tia::test {

/// What a finished process left.
struct Finished {
  int status = -1;  ///< exit status; 128 + n for signal n
  std::string out, err;
};

/// Folder: an empty one of our own, removed with all in it.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "tia-test-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Process: `tia` with these arguments and these additions to an environment without TIA_*.
/// Its outputs go to files, so that it never waits for a reader.
class Process {
 public:
  using Words = std::vector<std::string>;

  explicit Process(const Words& arguments, const Words& environment = {}) {
    Words all{TIA_BINARY};
    all.insert(all.end(), arguments.begin(), arguments.end());
    Words variables = environment;
    for (char** each = environ; *each != nullptr; ++each)
      if (!std::string_view(*each).starts_with("TIA_")) variables.emplace_back(*each);
    const auto pointers = [](Words& words) {
      std::vector<char*> list;
      for (std::string& word : words) list.push_back(word.data());
      list.push_back(nullptr);
      return list;
    };
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files, 1, folder_.file("out").c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&files, 2, folder_.file("err").c_str(), flags, 0600);
    posix_spawn_file_actions_addclosefrom_np(&files, 3);
    const int error = posix_spawn(&pid_, TIA_BINARY, &files, nullptr, pointers(all).data(),
                                  pointers(variables).data());
    posix_spawn_file_actions_destroy(&files);
    if (error != 0) throw std::runtime_error(std::string("cannot start ") + TIA_BINARY);
  }
  ~Process() {
    if (finished_) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number) { ::kill(pid_, number); }
  std::string out() const { return file_bytes(folder_.file("out")); }
  std::string err() const { return file_bytes(folder_.file("err")); }
  bool running() { return !reaped(); }

  /// Errors: std::runtime_error if it does not end in time.
  Finished wait(Clock::duration patience = seconds(60)) {
    if (!eventually([&] { return reaped(); }, patience))
      throw std::runtime_error("tia does not end");
    return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), out(), err()};
  }
  /// Processor time so far, in clock ticks.
  long ticks() const {
    std::istringstream stat(file_bytes(proc("stat")));
    std::string word;
    std::getline(stat, word, ')');
    for (int field = 3; field <= 13; ++field) stat >> word;
    long user = 0, system = 0;
    stat >> user >> system;
    return user + system;
  }
  std::string proc(const char* name) const { return "/proc/" + std::to_string(pid_) + "/" + name; }

 private:
  bool reaped() {
    if (!finished_) finished_ = ::waitpid(pid_, &status_, WNOHANG) == pid_;
    return finished_;
  }

  Folder folder_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool finished_ = false;
};

inline Finished run(const Process::Words& arguments, const Process::Words& environment = {}) {
  return Process(arguments, environment).wait();
}

/// Tia: `tia serve` on a free port, ready.
class Tia : public Process {
 public:
  explicit Tia(const Words& arguments = {"--port", "0"}, const Words& environment = {})
      : Process(arguments, environment) {
    if (!eventually([&] { return out().find('\n') != std::string::npos || !running(); }) ||
        !running())
      throw std::runtime_error("tia does not start: " + err());
    first_line_ = out().substr(0, out().find('\n'));
    const std::size_t colon = first_line_.rfind(':');
    port_ = std::stoi(first_line_.substr(colon + 1));
  }
  const std::string& first_line() const { return first_line_; }
  int port() const { return port_; }
  httplib::Client client() const {
    httplib::Client client("127.0.0.1", port_);
    client.set_read_timeout(60);
    return client;
  }
  Response get(const std::string& target) const { return plain(client().Get(target.c_str())); }

 private:
  std::string first_line_;
  int port_ = 0;
};

}  // namespace tia::test
