#include "server/operation/child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <system_error>

namespace tia::server {
namespace {

[[noreturn]] void fail(int error, const char* what) {
  throw std::system_error(error, std::generic_category(), what);
}

// Arguments of posix_spawn.
class SpawnPlan {
 public:
  SpawnPlan(int socket, bool is_quiet) {
    if (posix_spawn_file_actions_init(&actions_) != 0) fail(ENOMEM, "posix_spawn");
    if (posix_spawnattr_init(&attributes_) != 0) fail(ENOMEM, "posix_spawn");
    posix_spawn_file_actions_adddup2(&actions_, socket, 0);
    posix_spawn_file_actions_adddup2(&actions_, socket, 1);
    if (is_quiet) posix_spawn_file_actions_addopen(&actions_, 2, "/dev/null", O_WRONLY, 0);
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

}  // namespace

void Descriptor::close() {
  if (number_ >= 0) ::close(std::exchange(number_, -1));
}

Child::~Child() {
  if (pid_ == 0) return;
  kill();
  end();
}

void Child::kill() const { ::kill(pid_, SIGKILL); }

int Child::end() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = 0;
  return status;
}

StartedChild start_child(const std::string& program, const std::vector<std::string>& arguments,
                         bool is_quiet) {
  std::array<int, 2> pair{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair.data()) != 0)
    fail(errno, "socketpair");
  Descriptor ours(pair[0]);
  const Descriptor theirs(pair[1]);
  fcntl(ours, F_SETFL, O_NONBLOCK);
  Child child(SpawnPlan(theirs, is_quiet).start(program, arguments));
  return {std::move(ours), std::move(child)};
}

}  // namespace tia::server
