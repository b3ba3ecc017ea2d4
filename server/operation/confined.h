// A process of this program that can do nothing but read what it is given and answer: for what
// strangers send and libraries take apart.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "server/operation/byte_buffer.h"

namespace tia::server {

/// Confinement: the most that a process may take. Under sanitizers, which need more, only `cpu_s`.
struct Confinement {
  std::uint64_t memory_bytes = std::uint64_t{2} << 30U;  ///< address space
  unsigned cpu_s = 20;
};

/// From here on the calling process reads its standard input, writes its standard output and has
/// memory up to the limit; any other call of the kernel, such as to open a file, kills it (SIGSYS),
/// and so does more time (SIGXCPU); more memory is std::bad_alloc.
/// Errors: std::system_error where the kernel does not confine it. Source: seccomp(2),
/// setrlimit(2).
void confine(const Confinement& confinement);

/// How a process ended, as waitpid tells, and what it wrote.
struct ChildEnd {
  int status = 0;
  ByteBuffer output;
};

/// Starts a program with these arguments and without environment, sends it the pieces of input one
/// after the other and takes what it writes until it ends; what writes more than `most_output`
/// bytes is killed. The program's standard input and output are one socket. Its standard error is
/// ours. Errors: std::system_error where it cannot be started; Stopped, and then it is killed.
ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   const std::vector<std::span<const std::uint8_t>>& input, std::size_t most_output,
                   const std::stop_token& stop);

}  // namespace tia::server
