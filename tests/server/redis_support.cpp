#include "tests/server/redis_support.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <stdexcept>

namespace tia::test {

int free_port() {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  const bool is_bound = ::bind(socket, reinterpret_cast<const sockaddr*>(&address), size) == 0 &&
                        ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) == 0;
  ::close(socket);
  if (!is_bound) throw std::runtime_error("no free port");
  return ntohs(address.sin_port);
}

std::string RedisServer::program() {
  for (const char* path : {"/usr/bin/redis-server", "/usr/local/bin/redis-server"})
    if (::access(path, X_OK) == 0) return path;
  return "";
}

RedisServer::RedisServer(bool always, std::vector<std::string> more)
    : always_(always), more_(std::move(more)), port_(free_port()) {
  start();
}
RedisServer::~RedisServer() { kill(); }

server::RedisOptions RedisServer::options() const { return {.at = server::read_redis_url(url())}; }

bool RedisServer::answers() const {
  try {
    server::Redis(options()).call({"PING"});
    return true;
  } catch (const std::exception& error) {
    return std::string(error.what()).find("NOAUTH") != std::string::npos;
  }
}

void RedisServer::start() {
  std::vector<std::string> words{program(),
                                 "--port",
                                 std::to_string(port_),
                                 "--bind",
                                 "127.0.0.1",
                                 "--dir",
                                 folder_.file(""),
                                 "--save",
                                 "",
                                 "--appendonly",
                                 always_ ? "yes" : "no",
                                 "--appendfsync",
                                 always_ ? "always" : "no"};
  words.insert(words.end(), more_.begin(), more_.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, 1, folder_.file("out").c_str(),
                                   O_WRONLY | O_CREAT | O_APPEND, 0600);
  posix_spawn_file_actions_adddup2(&files, 1, 2);
  posix_spawn_file_actions_addclosefrom_np(&files, 3);
  const int error =
      ::posix_spawn(&pid_, program().c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error("cannot start redis-server");
  if (!eventually([&] { return answers(); }, seconds(10)))
    throw std::runtime_error("redis-server does not answer: " + file_bytes(folder_.file("out")));
}

void RedisServer::signal(int number) const { ::kill(pid_, number); }

void RedisServer::kill() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

RedisServer& shared_redis() {
  static RedisServer server;
  return server;
}
RedisServer& empty_redis() {
  server::Redis(shared_redis().options()).call({"FLUSHALL"});
  return shared_redis();
}

}  // namespace tia::test
