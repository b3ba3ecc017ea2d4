#include "tests/server/process_support.h"

#include <fcntl.h>
#include <httplib.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace tia::test {

Folder::Folder() {
  std::string name = (std::filesystem::temp_directory_path() / "tia-test-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make " + name);
  path_ = name;
}
Folder::~Folder() { std::filesystem::remove_all(path_); }
std::string Folder::file(const std::string& name) const { return (path_ / name).string(); }

// ---- Process --------------------------------------------------------------------------------

Process::Process(const Words& arguments, const Words& environment, int error_output,
                 std::int64_t most_addresses) {
  std::string program = tia_program();
  Words all{program};
  if (most_addresses > 0) {  // the shell sets the limit and becomes the program
    const std::string limit = "ulimit -v " + std::to_string(most_addresses / 1024);
    all = {"sh", "-c", limit + R"( && exec "$0" "$@")", program};
    program = "/bin/sh";
  }
  all.insert(all.end(), arguments.begin(), arguments.end());
  Words variables = environment;
  for (char** each = environ; *each != nullptr; ++each)
    if (!std::string_view(*each).starts_with("TIA_")) variables.emplace_back(*each);
  const auto pointers = [](Words& words) {
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    return list;
  };
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, folder_.file("out").c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&files, 2, folder_.file("err").c_str(), flags, 0600);
  if (error_output >= 0) posix_spawn_file_actions_adddup2(&files, error_output, 2);
  posix_spawn_file_actions_addclosefrom_np(&files, 3);
  const int error = posix_spawn(&pid_, program.c_str(), &files, nullptr, pointers(all).data(),
                                pointers(variables).data());
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("cannot start " + program);
}
Process::~Process() {
  if (finished_) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Process::signal(int number) { ::kill(pid_, number); }
std::string Process::out() const { return file_bytes(folder_.file("out")); }
std::string Process::err() const { return file_bytes(folder_.file("err")); }

Finished Process::wait(Clock::duration timeout) {
  if (!eventually([&] { return reaped(); }, timeout)) throw std::runtime_error("tia does not end");
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), out(), err()};
}
long Process::ticks() const {
  std::istringstream stat(file_bytes(proc("stat")));
  std::string word;
  std::getline(stat, word, ')');
  for (int field = 3; field <= 13; ++field) stat >> word;
  long user = 0, system = 0;
  stat >> user >> system;
  return user + system;
}
std::string Process::proc(const char* name) const {
  return "/proc/" + std::to_string(pid_) + "/" + name;
}
bool Process::reaped() {
  if (!finished_) finished_ = ::waitpid(pid_, &status_, WNOHANG) == pid_;
  return finished_;
}

Finished run(const Process::Words& arguments, const Process::Words& environment) {
  return Process(arguments, environment).wait();
}

// ---- Tia ------------------------------------------------------------------------------------

Tia::Tia() : Tia({"--port", "0"}) {}
namespace {

// Most requests of these tests are sent to "x".
Process::Words with_any_host(Process::Words environment) {
  const auto names_hosts = [](const std::string& each) { return each.starts_with("TIA_HOSTS="); };
  if (std::none_of(environment.begin(), environment.end(), names_hosts))
    environment.emplace_back("TIA_HOSTS=*");
  return environment;
}

}  // namespace

Tia::Tia(const Words& arguments, const Words& environment, int error_output,
         std::int64_t most_addresses)
    : Process(arguments, with_any_host(environment), error_output, most_addresses) {
  if (!eventually([&] { return out().find('\n') != std::string::npos || !running(); }) ||
      !running())
    throw std::runtime_error("tia does not start: " + err());
  first_line_ = out().substr(0, out().find('\n'));
  const std::size_t colon = first_line_.rfind(':');
  port_ = std::stoi(first_line_.substr(colon + 1));
  served_.emplace(port_);
}
httplib::Client Tia::client() const {
  httplib::Client client("127.0.0.1", port_);
  client.set_read_timeout(60);
  return client;
}
Response Tia::get(const std::string& target) const {
  return plain("GET", target, client().Get(target.c_str()));
}

long kilobytes(const Process& process, const std::string& name) {
  std::istringstream lines(file_bytes(process.proc("status")));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(name + ':')) return std::stol(line.substr(name.size() + 1));
  throw std::runtime_error("no " + name);
}
std::size_t entries(const Process& process, const char* folder) {
  const std::filesystem::directory_iterator all(process.proc(folder));
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

}  // namespace tia::test
