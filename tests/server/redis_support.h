// A Redis of the test's own: a process on a free port of the loopback, in a folder of its own.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "server/stores/redis.h"
#include "tests/server/process_support.h"

namespace tia::test {

/// A port of the loopback that nobody listens on.
int free_port();

/// RedisServer: empty, and ready.
class RedisServer {
 public:
  /// Where the program is, or "": then tests that need it are skipped.
  static std::string program();

  /// Syncs whatever it keeps before it answers where `always` says so. `more`: further arguments.
  explicit RedisServer(bool always = false, std::vector<std::string> more = {});
  ~RedisServer();
  RedisServer(const RedisServer&) = delete;
  RedisServer& operator=(const RedisServer&) = delete;

  int port() const { return port_; }
  std::string url() const { return "redis://127.0.0.1:" + std::to_string(port_) + "/0"; }
  server::RedisOptions options() const;
  /// A file of its folder.
  std::string file(const std::string& name) const { return folder_.file(name); }
  void signal(int number) const;
  /// kill -9; what it has on its disk is there when it starts again.
  void kill();
  void start();

 private:
  bool answers() const;

  Folder folder_;
  const bool always_;
  const std::vector<std::string> more_;
  int port_ = 0;
  pid_t pid_ = -1;
};

/// The one that all quick tests of a program share; and the same, emptied.
RedisServer& shared_redis();
RedisServer& empty_redis();

}  // namespace tia::test
