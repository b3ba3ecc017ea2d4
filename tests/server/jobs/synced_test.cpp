// What is promised is on the disk before it is said: the order of system calls, as strace sees
// them.
#include <httplib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <map>

#include "tests/server/redis_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

constexpr const char* strace = "/usr/bin/strace";

/// Traced: writes and syncs of processes, with the names of their files, in the order in which they
/// began and ended.
class Traced {
 public:
  explicit Traced(const std::vector<pid_t>& processes) {
    std::vector<std::string> words{
        strace,     "-f",   "-y",
        "-s",       "4096", "-o",
        log_name(), "-e",   "trace=write,pwrite64,writev,sendto,sendmsg,fsync,fdatasync"};
    for (const pid_t process : processes)
      words.insert(words.end(), {"-p", std::to_string(process)});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::ofstream(folder_.file("told")).close();
    pid_ = ::fork();
    if (pid_ != 0) return;
    static_cast<void>(std::freopen(folder_.file("told").c_str(), "w", stderr));
    ::execv(strace, arguments.data());
    ::_exit(127);
  }
  ~Traced() { stop(); }
  Traced(const Traced&) = delete;
  Traced& operator=(const Traced&) = delete;

  /// Whether it may look at as many processes as that.
  bool looks_at(int processes) const {
    const auto attached = [&] {
      const std::string told = file_bytes(folder_.file("told"));
      int count = 0;
      for (auto at = told.find(" attached"); at != told.npos; at = told.find(" attached", at + 1))
        ++count;
      return count;
    };
    return eventually([&] { return attached() >= processes || ::kill(pid_, 0) != 0; }) &&
           attached() >= processes;
  }
  /// The lines, once nothing more is looked at.
  std::vector<std::string> lines() {
    stop();
    std::ifstream log(log_name());
    std::vector<std::string> all;
    for (std::string line; std::getline(log, line);) all.push_back(line);
    return all;
  }

 private:
  std::string log_name() const { return folder_.file("log"); }
  void stop() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGINT);
    ::waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }
  Folder folder_;
  pid_t pid_ = -1;
};

bool has(const std::string& line, const char* text) { return line.find(text) != line.npos; }
std::string thread_of(const std::string& line) { return line.substr(0, line.find(' ')); }

/// Unsynced: of a file, by thread, whether what it has written is not on the disk yet.
class Unsynced {
 public:
  explicit Unsynced(const char* file) : file_(file) {}

  void look(const std::string& line) {
    const std::string thread = thread_of(line);
    if (has(line, "sync resumed>") && syncing_[thread]) unsynced_[thread] = false;
    if (!has(line, file_)) return;
    if (has(line, "write(") || has(line, "write64(") || has(line, "writev(")) {
      if (first_.empty()) first_ = thread;
      unsynced_[thread] = true;
    }
    if (!has(line, "fdatasync(") && !has(line, "fsync(")) return;
    syncing_[thread] = has(line, "<unfinished");
    if (!syncing_[thread]) unsynced_[thread] = false;
  }
  bool has_written() const { return !first_.empty(); }
  bool of_first() { return unsynced_[first_]; }
  bool of_any() const {
    return std::ranges::any_of(unsynced_, [](const auto& each) { return each.second; });
  }
  bool of(const std::string& thread) { return unsynced_[thread]; }

 private:
  const char* file_;
  std::string first_;
  std::map<std::string, bool> unsynced_, syncing_;
};

pid_t process_of(const RedisServer& redis) {
  const std::string told = server::Redis(redis.options()).call({"INFO", "server"}).words;
  return std::stoi(told.substr(told.find("process_id:") + 11));
}

const char* const small_job = R"({"kind":"render","request":{"width":16,"height":12}})";

// Its job has one part: once that is told, nobody writes any more.
TEST(Synced, AreAJobBeforeItsAnswerAndAResultBeforeItIsTold) {
  if (::access(strace, X_OK) != 0) GTEST_SKIP() << "strace is not installed";
  if (sanitized()) GTEST_SKIP() << "a leak's search is strace's to look at";
  const Folder folder;
  const Tia tia({}, {"TIA_DATA_DIR=" + folder.file("")});
  Traced traced({tia.pid()});
  if (!traced.looks_at(1)) GTEST_SKIP() << "strace may not look at others here";
  const auto answer = tia.client().Post("/jobs", small_job, "application/json");
  ASSERT_TRUE(answer && answer->status == 202);
  const std::string job = answer->get_header_value("Location");
  EXPECT_THAT(tia.get(job + "/events").body, testing::HasSubstr(R"({"state":"done"})"));
  Unsynced file("jobs.sqlite-wal>");
  bool is_answered = false, is_told = false;
  for (const std::string& line : traced.lines()) {
    file.look(line);
    if (!has(line, "sendmsg(") || is_told) continue;
    if (has(line, "HTTP/1.1 202")) {
      is_answered = true;
      EXPECT_TRUE(file.has_written()) << line;
      EXPECT_FALSE(file.of_first()) << line;
    } else if (has(line, R"({\"state\":\"done\"})")) {
      is_told = true;
      EXPECT_FALSE(file.of_any()) << line;
    }
  }
  EXPECT_TRUE(is_answered && is_told);
}

// Whatever it answers, and so before anybody is answered 202 by who has asked it.
TEST(Synced, IsAFarmsRedisBeforeItAnswers) {
  if (::access(strace, X_OK) != 0) GTEST_SKIP() << "strace is not installed";
  if (RedisServer::program().empty()) GTEST_SKIP() << "redis-server is not installed";
  if (sanitized()) GTEST_SKIP() << "a leak's search is strace's to look at";
  const RedisServer redis(true);
  const Tia tia({}, {"TIA_FARM=" + redis.url()});
  Traced traced({tia.pid(), process_of(redis)});
  if (!traced.looks_at(2)) GTEST_SKIP() << "strace may not look at others here";
  const auto answer = tia.client().Post("/jobs", small_job, "application/json");
  ASSERT_TRUE(answer && answer->status == 202);
  Unsynced file("appendonly.aof");
  bool is_answered = false;
  for (const std::string& line : traced.lines()) {
    file.look(line);
    if (has(line, "sendmsg(") && has(line, "HTTP/1.1 202")) {
      is_answered = true;
      EXPECT_TRUE(file.has_written()) << line;
    }
    if (has(line, "<socket:") || has(line, "<TCP:")) EXPECT_FALSE(file.of(thread_of(line))) << line;
  }
  EXPECT_TRUE(is_answered);
}

}  // namespace
}  // namespace tia::test
