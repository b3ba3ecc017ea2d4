#include "server/operation/child_filter.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <array>
#include <cerrno>
#include <stdexcept>

#include "core/parallel/stopped.h"

namespace tia::server {
namespace {

constexpr int look_ms = 50;  // for a stop

void set_limit_of(pid_t child, decltype(RLIMIT_AS) which, rlim_t most) {
  const rlimit limit{most, most};
  prlimit(child, which, &limit, nullptr);  // of one that has ended already it does not matter
}

void wait_for(int socket, short events) {
  pollfd ready{socket, events, 0};
  poll(&ready, 1, look_ms);
}

}  // namespace

// Source: prlimit(2). The program reads nothing before it has them.
ChildFilter::ChildFilter(const std::string& program, const std::vector<std::string>& arguments,
                         const ChildLimits& limits)
    : started_(start_child(program, arguments, true)) {
  const pid_t child = started_.child.pid();
  set_limit_of(child, RLIMIT_AS, limits.memory_bytes);
  set_limit_of(child, RLIMIT_CPU, limits.cpu_s);
  set_limit_of(child, RLIMIT_FSIZE, 0);
  set_limit_of(child, RLIMIT_CORE, 0);
}

// Takes what has come.
void ChildFilter::take(std::string& output) {
  std::array<char, 1 << 16> piece;
  while (!has_ended_) {
    const ssize_t got = recv(started_.socket, piece.data(), piece.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && errno == EAGAIN) return;
    if (got <= 0) has_ended_ = true;
    else output.append(piece.data(), static_cast<std::size_t>(got));
  }
}

std::string ChildFilter::pass(std::string_view bytes, const std::stop_token& stop) {
  std::string output;
  for (;;) {
    end_if_asked(stop);
    take(output);
    if (has_ended_) throw std::runtime_error("the encoder has ended before its film");
    if (bytes.empty()) return output;
    const ssize_t sent = send(started_.socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent >= 0) bytes.remove_prefix(static_cast<std::size_t>(sent));
    else if (errno == EAGAIN) wait_for(started_.socket, POLLIN | POLLOUT);
    else if (errno != EINTR) throw std::runtime_error("the encoder has ended before its film");
  }
}

std::string ChildFilter::finish(const std::stop_token& stop) {
  std::string output;
  shutdown(started_.socket, SHUT_WR);
  for (take(output); !has_ended_; take(output)) {
    end_if_asked(stop);
    wait_for(started_.socket, POLLIN);
  }
  const int status = started_.child.end();
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw std::runtime_error("the encoder has failed, status " + std::to_string(status));
  return output;
}

}  // namespace tia::server
