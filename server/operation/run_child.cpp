#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include "core/parallel/stopped.h"
#include "server/operation/confined.h"

namespace tia::server {
namespace {

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

/// Descriptor: closed with its owner.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  operator int() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

// Arguments of posix_spawn.
class SpawnPlan {
 public:
  explicit SpawnPlan(int socket) {
    if (posix_spawn_file_actions_init(&actions_) != 0) fail(ENOMEM, "posix_spawn");
    if (posix_spawnattr_init(&attributes_) != 0) fail(ENOMEM, "posix_spawn");
    posix_spawn_file_actions_adddup2(&actions_, socket, 0);
    posix_spawn_file_actions_adddup2(&actions_, socket, 1);
    posix_spawn_file_actions_addclosefrom_np(&actions_, 3);
    // The server's own threads hold back signals; a child must not.
    sigset_t none, all;
    sigemptyset(&none);
    sigfillset(&all);
    posix_spawnattr_setsigmask(&attributes_, &none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }

  pid_t start(const std::string& program, const std::vector<std::string>& arguments) const {
    std::vector<char*> list{const_cast<char*>(program.c_str())};
    for (const std::string& each : arguments) list.push_back(const_cast<char*>(each.c_str()));
    list.push_back(nullptr);
    char* none = nullptr;
    pid_t child = 0;
    const int error =
        posix_spawn(&child, program.c_str(), &actions_, &attributes_, list.data(), &none);
    if (error != 0) fail(error, "posix_spawn");
    return child;
  }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

/// Child: killed and waited for, unless it has ended.
class Child {
 public:
  explicit Child(pid_t pid) : pid_(pid) {}
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() {
    if (pid_ == 0) return;
    kill();
    end();
  }
  void kill() const { ::kill(pid_, SIGKILL); }
  /// Waits for its end. Returns: its status.
  int end() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = 0;
    return status;
  }

 private:
  pid_t pid_;
};

// What is still to be sent.
class Pieces {
 public:
  explicit Pieces(const std::vector<std::span<const std::uint8_t>>& pieces) : pieces_(pieces) {
    skip_empty();
  }
  bool done() const { return at_ == pieces_.size(); }
  // Sends as much as the socket takes now. Returns: whether somebody still reads.
  bool send_to(int socket) {
    const auto left = pieces_[at_].subspan(sent_);
    const ssize_t sent = send(socket, left.data(), left.size(), MSG_NOSIGNAL);
    if (sent < 0) return errno == EAGAIN || errno == EINTR;
    sent_ += static_cast<std::size_t>(sent);
    skip_empty();
    return true;
  }

 private:
  void skip_empty() {
    for (; at_ < pieces_.size() && sent_ == pieces_[at_].size(); ++at_) sent_ = 0;
  }
  const std::vector<std::span<const std::uint8_t>>& pieces_;
  std::size_t at_ = 0, sent_ = 0;
};

// Takes what has come, but no more than is needed to tell that it is too much. Domain: it is not
// yet. Returns: whether more may come.
bool receive(int socket, std::size_t most, ByteBuffer& output) {
  constexpr std::size_t piece = 1 << 16;
  const auto room = output.room(piece);
  const ssize_t got = recv(socket, room.data(), std::min(room.size(), most - output.size() + 1), 0);
  if (got < 0) return errno == EAGAIN || errno == EINTR;
  output.add(static_cast<std::size_t>(got));
  return got > 0;
}

void exchange(int socket, Pieces input, std::size_t most, const std::stop_token& stop,
              ByteBuffer& output) {
  constexpr int look_up_ms = 50;  // for a stop
  bool sending = true;
  for (;;) {
    end_if_asked(stop);
    if (sending && input.done()) {
      shutdown(socket, SHUT_WR);
      sending = false;
    }
    pollfd ready{socket, static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0};
    if (poll(&ready, 1, look_up_ms) <= 0) continue;
    if (sending && (ready.revents & POLLOUT) != 0 && !input.send_to(socket)) sending = false;
    if ((ready.revents & (POLLIN | POLLHUP | POLLERR)) != 0 && !receive(socket, most, output))
      return;
    if (output.size() > most) return;
  }
}

}  // namespace

ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   const std::vector<std::span<const std::uint8_t>>& input, std::size_t most_output,
                   const std::stop_token& stop) {
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0)
    fail(errno, "socketpair");
  const Descriptor ours(pair[0]);
  Descriptor theirs(pair[1]);
  fcntl(ours, F_SETFL, O_NONBLOCK);
  Child child(SpawnPlan(theirs).start(program, arguments));
  theirs.close();
  ChildEnd end;
  exchange(ours, Pieces(input), most_output, stop, end.output);
  if (end.output.size() > most_output) child.kill();
  end.status = child.end();
  return end;
}

}  // namespace tia::server
