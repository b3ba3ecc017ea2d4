// R17: a call of the C library fails while the program starts, or while it reads and writes the
// files of `tia render`.
#include <signal.h>

#include <cerrno>

#include "tests/server/faults/faults_support.h"

namespace tia::test {
namespace {

// ---- while it starts ------------------------------------------------------------------------

// What the globals of a library (CLI11's) and of C++'s own take before main(), where nobody can
// catch what they throw.
constexpr long before_main = 11;

// Not epoll_ctl: asio does not look whether it is done for the descriptors that wake it up.
const BrokenCall starting[] = {
    {faults_pthread_create, EAGAIN}, {faults_socket, EMFILE},        {faults_bind, EADDRINUSE},
    {faults_listen, EADDRINUSE},     {faults_epoll_create1, EMFILE}, {faults_eventfd, EMFILE},
    {faults_timerfd_create, EMFILE}, {faults_setsockopt, ENOBUFS},   {faults_ioctl, ENOMEM},
    {faults_write, ENOSPC},          {faults_malloc, ENOMEM}};

class BrokenStart : public testing::TestWithParam<BrokenCall> {
 protected:
  // Serves as ever and ends as told, or says why not and leaves. Returns: whether a call failed.
  bool starts_or_says_why() {
    Process tia({"--port", "0", "--threads", "2", "--hosts", "*"}, faults_.environment());
    const auto has_spoken = [&] { return tia.out().find('\n') != std::string::npos; };
    EXPECT_TRUE(eventually([&] { return has_spoken() || !tia.running(); }));
    const bool failed = faults_.failed() > 0;
    faults_.end();
    if (has_spoken() && tia.running()) {
      const int port = std::stoi(tia.out().substr(tia.out().rfind(':') + 1));
      EXPECT_EQ(exchange(port, "GET /render HTTP/1.1\r\nHost: x\r\n\r\n").status, 200);
      tia.signal(SIGTERM);
    }
    const Finished end = tia.wait(seconds(10));
    if (end.status == 0) return failed;
    EXPECT_EQ(end.status, 2);
    EXPECT_THAT(end.err, testing::StartsWith("tia: "));
    if (GetParam().call == faults_pthread_create) {
      EXPECT_THAT(end.err, testing::HasSubstr("TIA_THREADS"));
    }
    return failed;
  }

  Faults faults_;
};

TEST_P(BrokenStart, IsAStartOrAWordOfWhatIsWrong) {
  if (sanitized() && GetParam().call == faults_malloc)
    GTEST_SKIP() << "has an allocator of its own";
  const long first = GetParam().call == faults_malloc ? 1 + before_main : 1;
  long n = first;
  for (bool failed = true; failed && !HasFailure(); n += 1 + n / 40) {
    SCOPED_TRACE(n);
    faults_.once(GetParam(), n);
    failed = starts_or_says_why();
  }
  RecordProperty("calls", static_cast<int>(n));
  EXPECT_GT(n, first + 1);
}

// ---- files ----------------------------------------------------------------------------------

const BrokenCall of_files[] = {
    {faults_fopen, EMFILE}, {faults_read, EINTR},    {faults_read, EIO}, {faults_read, 0},
    {faults_writev, EINTR}, {faults_writev, ENOSPC}, {faults_writev, 0}};

class BrokenFile : public testing::TestWithParam<BrokenCall> {};

TEST_P(BrokenFile, IsWrittenWholeOrNotAtAll) {
  const Folder folder;
  const std::string from = folder.file("scene.json"), to = folder.file("picture.pfm");
  std::filesystem::copy_file(std::string(TIA_SOURCE_DIR) + "/web/scenes/thesis.json", from);
  const auto draw = [&](const Process::Words& environment) {
    std::filesystem::remove(to);
    return run({"render", from, "--width", "80", "--height", "60", "-o", to}, environment);
  };
  draw({});
  const std::string due = file_bytes(to);
  Faults faults;
  faults.only_below(std::filesystem::path(from).parent_path());
  bool failed = true;
  long n = 1;
  for (; failed && n < 100; ++n) {
    SCOPED_TRACE(n);
    faults.once(GetParam(), n);
    const Finished end = draw(faults.environment());
    failed = faults.failed() > 0;
    if (end.status == 0) {
      EXPECT_TRUE(file_bytes(to) == due);
    } else {
      EXPECT_EQ(end.status, 2);
      EXPECT_THAT(end.err, testing::StartsWith("tia: cannot "));
      EXPECT_FALSE(std::filesystem::exists(to));
      EXPECT_TRUE(failed);
    }
  }
  EXPECT_GT(n, 2);
}

INSTANTIATE_TEST_SUITE_P(Of, BrokenFile, testing::ValuesIn(of_files),
                         [](const auto& one) { return name_of(one.param); });

INSTANTIATE_TEST_SUITE_P(Of, BrokenStart, testing::ValuesIn(starting),
                         [](const auto& one) { return name_of(one.param); });

}  // namespace
}  // namespace tia::test
