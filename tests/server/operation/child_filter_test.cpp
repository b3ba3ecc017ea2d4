// A program that is fed and read by turns.
#include "server/operation/child_filter.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "core/parallel/stopped.h"

namespace tia::server {
namespace {

ChildFilter shell_filter(const std::string& script) {
  return ChildFilter("/bin/sh", {"-c", script}, {});
}

// Neither runs nor waits to be waited for.
void expect_gone(pid_t child) {
  EXPECT_EQ(kill(child, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}
// What a shell has said of itself, in a line.
pid_t told_by(ChildFilter& shell) {
  std::string said;
  while (!said.ends_with('\n')) said += shell.pass("", {});
  return std::stoi(said);
}

TEST(ChildFilter, GivesBackAllThatPassesThroughHoweverMuch) {
  ChildFilter cat = shell_filter("echo $$; exec cat");
  const pid_t child = told_by(cat);
  std::string in, out;
  for (int i = 0; i < 40; ++i) {
    const std::string piece(100'000, static_cast<char>('a' + i % 26));
    in += piece;
    out += cat.pass(piece, {});
  }
  EXPECT_GT(out.size(), in.size() / 2) << "as it comes";
  out += cat.finish({});
  EXPECT_TRUE(out == in);
  expect_gone(child);
}

TEST(ChildFilter, ThatFailsIsNeverDone) {
  EXPECT_THROW(shell_filter("cat; exit 3").finish({}), std::runtime_error);
  EXPECT_THROW(shell_filter("kill -9 $$").finish({}), std::runtime_error);
  ChildFilter gone = shell_filter("exit 0");
  const std::string much(1 << 20, 'x');
  EXPECT_THROW(gone.pass(much, {}), std::runtime_error) << "before all was read";
  EXPECT_THROW(ChildFilter("/nowhere/none", {}, {}), std::system_error);
}

TEST(ChildFilter, ThatNeitherReadsNorEndsIsKilledOnceItIsStopped) {
  std::stop_source stop;
  pid_t child = 0;
  {
    ChildFilter deaf = shell_filter("echo $$; exec sleep 1000");
    child = told_by(deaf);
    std::jthread soon([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      stop.request_stop();
    });
    const std::string much(4 << 20, 'x');
    EXPECT_THROW(deaf.pass(much, stop.get_token()), Stopped);
    EXPECT_THROW(deaf.finish(stop.get_token()), Stopped);
  }
  expect_gone(child);
}

TEST(ChildFilter, HasItsOwnLimitsAndNothingOfOurs) {
  ChildFilter limits("/bin/sh", {"-c", "read go; ulimit -v; ulimit -t; ulimit -f; echo $HOME"},
                     {.memory_bytes = 1 << 30, .cpu_s = 7});
  const std::string said = limits.pass("go\n", {});
  EXPECT_EQ(said + limits.finish({}), "1048576\n7\n0\n\n");
}

}  // namespace
}  // namespace tia::server
