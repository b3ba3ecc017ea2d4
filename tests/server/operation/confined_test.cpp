// What a confined process may do, which is nothing but answer; and what becomes of children.
#include "server/operation/confined.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <new>
#include <thread>

#include "core/parallel/stopped.h"
#include "tests/sanitizer.h"

namespace tia::server {
namespace {

std::string text_of(const ByteBuffer& bytes) { return {bytes.begin(), bytes.end()}; }
std::span<const std::uint8_t> bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// ---- confine
// -------------------------------------------------------------------------------------

// How a process ends that confines itself and then does something. It ends with what that returns.
int end_of(int (*deed)(), const Confinement& confinement = {std::uint64_t{1} << 30U, 1}) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      confine(confinement);
    } catch (...) {
      _exit(99);
    }
    syscall(SYS_exit_group, deed());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

struct Deed {
  const char* name;
  int (*deed)();
};
class Confined : public testing::TestWithParam<Deed> {
 protected:
  void SetUp() override {
    if (test::sanitized()) GTEST_SKIP() << "sanitizers need more than a confined process may";
  }
};

// Each is called by its number, so that no library stands between.
TEST_P(Confined, IsKilledByWhatIsNotAnswering) {
  const int status = end_of(GetParam().deed);
  ASSERT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
  EXPECT_EQ(WTERMSIG(status), SIGSYS);
}

int called(long number, long a = 0, long b = 0, long c = 0) {
  return static_cast<int>(syscall(number, a, b, c)) & 63;
}
INSTANTIATE_TEST_SUITE_P(
    Calls, Confined,
    testing::Values(
        Deed{"open", [] { return called(SYS_openat, AT_FDCWD, long("/etc/passwd"), O_RDONLY); }},
        Deed{"fork", [] { return called(SYS_clone, SIGCHLD); }},
        Deed{"exec", [] { return called(SYS_execve, long("/bin/true")); }},
        Deed{"socket", [] { return called(SYS_socket, AF_INET, SOCK_STREAM); }},
        Deed{"connect", [] { return called(SYS_connect, 1); }},
        Deed{"kill", [] { return called(SYS_kill, 1, 0); }},
        Deed{"ptrace", [] { return called(SYS_ptrace); }},
        Deed{"stat", [] { return called(SYS_newfstatat, AT_FDCWD, long("/")); }},
        Deed{"unlink", [] { return called(SYS_unlinkat, AT_FDCWD, long("/tmp/none")); }},
        Deed{"dup", [] { return called(SYS_dup, 1); }},
        Deed{"prctl", [] { return called(SYS_prctl); }},
        Deed{"setrlimit", [] { return called(SYS_setrlimit); }},
        Deed{"mprotect", [] { return called(SYS_mprotect); }},
        Deed{"read of another", [] { return called(SYS_read, 2); }},
        Deed{"write to another", [] { return called(SYS_write, 2, long("x"), 1); }},
        Deed{"mmap of a file",
             [] {
               return static_cast<int>(
                   syscall(SYS_mmap, nullptr, 4096, PROT_READ, MAP_PRIVATE, 1, 0) & 63);
             }}),
    [](const auto& deed) {
      std::string name = deed.param.name;
      for (char& each : name)
        if (each == ' ') each = '_';
      return name;
    });

TEST_F(Confined, MayHaveMemoryUpToItsLimit) {
  const auto takes = [] {
    const auto taken = [](std::size_t bytes) {
      return mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
             MAP_FAILED;
    };
    return taken(100'000'000) && !taken(std::size_t{64} << 30U) ? 7 : 2;
  };
  const int status = end_of(takes, {std::uint64_t{32} << 30U, 1});
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST_F(Confined, IsKilledWhenItsTimeIsOver) {
  const int status = end_of([] {
    for (std::atomic<unsigned> i = 0;; ++i) {
    }
    return 0;
  });
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_EQ(WTERMSIG(status), SIGXCPU);
}

// ---- children
// ------------------------------------------------------------------------------------

ChildEnd shell(const std::string& script, const std::string& input = {}, std::size_t most = 1 << 20,
               const std::stop_token& stop = {}) {
  return run_child("/bin/sh", {"-c", script}, {bytes_of(input)}, most, stop);
}

TEST(RunChild, GivesItAllPiecesAndTakesAllItWrites) {
  const std::string long_piece(3'000'000, 'x');
  const ChildEnd end =
      run_child("/bin/cat", {}, {bytes_of("one"), {}, bytes_of(long_piece), bytes_of("two")},
                std::size_t{4} << 20U, {});
  EXPECT_EQ(end.status, 0);
  EXPECT_TRUE(text_of(end.output) == "one" + long_piece + "two");
}

TEST(RunChild, TellsHowItEnded) {
  const ChildEnd exited = shell("exit 7");
  EXPECT_TRUE(WIFEXITED(exited.status) && WEXITSTATUS(exited.status) == 7);
  const ChildEnd killed = shell("printf some; kill -SEGV $$");
  EXPECT_TRUE(WIFSIGNALED(killed.status) && WTERMSIG(killed.status) == SIGSEGV);
  EXPECT_EQ(text_of(killed.output), "some");
}

TEST(RunChild, NeedNotReadWhatItIsGiven) {
  const ChildEnd end = shell("exit 3", std::string(5'000'000, 'x'));
  EXPECT_TRUE(WIFEXITED(end.status) && WEXITSTATUS(end.status) == 3);
}

TEST(RunChild, HasNeitherEnvironmentNorDescriptors) {
  setenv("TIA_SECRET", "yes", 1);
  const int open_one = open("/dev/null", O_RDONLY);  // not closed by exec
  EXPECT_EQ(text_of(shell("echo ${TIA_SECRET-none}; ls /proc/self/fd | wc -l").output),
            "none\n4\n");  // and the folder's own
  close(open_one);
  unsetenv("TIA_SECRET");
}

TEST(RunChild, IsKilledWhenItWritesTooMuch) {
  const ChildEnd end = shell("cat /dev/zero", {}, 100'000);
  EXPECT_TRUE(WIFSIGNALED(end.status) && WTERMSIG(end.status) == SIGKILL);
  EXPECT_GT(end.output.size(), 100'000U);
  EXPECT_LT(end.output.size(), 200'000U);
}

TEST(RunChild, IsKilledWhenNobodyWantsItAnyMore) {
  std::stop_source source;
  const std::jthread asker([&] { source.request_stop(); });
  EXPECT_THROW(shell("while :; do :; done", {}, 1000, source.get_token()), Stopped);
}

TEST(RunChild, ThatIsNotThereIsAnError) {
  EXPECT_THROW(run_child("/nowhere/none", {}, {}, 10, {}), std::system_error);
}

}  // namespace
}  // namespace tia::server
