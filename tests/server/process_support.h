// The program itself, as a process: started, read, signalled and waited for, always with a
// deadline.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/server/program.h"
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
  Folder();
  ~Folder();
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::string file(const std::string& name) const;

 private:
  std::filesystem::path path_;
};

/// Process: `tia` with these arguments and these additions to an environment without TIA_*.
/// Its outputs go to files, so that it never waits for a reader; the error output elsewhere where a
/// descriptor is given. `most_addresses`: what its addresses may span (RLIMIT_AS); 0: no limit.
class Process {
 public:
  using Words = std::vector<std::string>;

  explicit Process(const Words& arguments, const Words& environment = {}, int error_output = -1,
                   std::int64_t most_addresses = 0);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t pid() const { return pid_; }
  void signal(int number);
  std::string out() const;
  std::string err() const;
  bool running() { return !reaped(); }

  /// Errors: std::runtime_error if it does not end in time.
  Finished wait(Clock::duration timeout = seconds(60));
  /// Processor time so far, in clock ticks.
  long ticks() const;
  std::string proc(const char* name) const;

 private:
  bool reaped();

  Folder folder_;
  pid_t pid_ = -1;
  int status_ = 0;
  bool finished_ = false;
};

Finished run(const Process::Words& arguments, const Process::Words& environment = {});

/// Tia: `tia serve` on a free port, ready.
class Tia : public Process {
 public:
  Tia();
  explicit Tia(const Words& arguments, const Words& environment = {}, int error_output = -1,
               std::int64_t most_addresses = 0);
  const std::string& first_line() const { return first_line_; }
  int port() const { return port_; }
  httplib::Client client() const;
  Response get(const std::string& target) const;

 private:
  std::string first_line_;
  int port_ = 0;
  std::optional<ServicePort> served_;
};

// ---- what a process holds -------------------------------------------------------------------

/// KiB by that name in /proc/PID/status, such as "VmRSS" now and "VmHWM" at most so far.
long kilobytes(const Process& process, const std::string& name = "VmRSS");
/// How many entries a folder of /proc/PID has: of "fd" the open descriptors, of "task" the threads.
std::size_t entries(const Process& process, const char* folder);

}  // namespace tia::test
