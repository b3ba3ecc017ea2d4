// A program as a child of this one, at the other end of a socket.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace tia::server {

/// Descriptor: closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& from) noexcept : number_(std::exchange(from.number_, -1)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  operator int() const { return number_; }
  void close();

 private:
  int number_;
};

/// Child: killed and waited for, unless it has ended.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(Child&& from) noexcept : pid_(std::exchange(from.pid_, 0)) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child();
  pid_t pid() const { return pid_; }
  void kill() const;
  /// Waits for its end. Returns: its status, as waitpid has it.
  int end();

 private:
  pid_t pid_;
};

/// StartedChild: one, and our end of its standard input and output, which never blocks.
struct StartedChild {
  Descriptor socket;
  Child child;
};

/// Starts a program with these arguments, without environment, with all signals as they are at
/// first, and with no descriptor of ours but standard error, or not even that where it is `quiet`.
/// Errors: std::system_error where it cannot be started.
StartedChild start_child(const std::string& program, const std::vector<std::string>& arguments,
                         bool is_quiet = false);

}  // namespace tia::server
