// Redis: calls of one, by as many connections as there are callers, which come back by themselves.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "server/stores/redis_address.h"
#include "server/stores/redis_reply.h"
#include "server/stores/redis_socket.h"

namespace tia::server {

/// All keys and channels of a farm begin so: one slot of a cluster, and the layout's number.
constexpr std::string_view farm_prefix = "{tia}:1:";

/// RedisOptions: which one, and what its calls may take.
struct RedisOptions {
  RedisAddress at = {};
  std::string password = {};  ///< "": none is asked for
  std::string ca_file = {};   ///< of certificates; "": the system's
  std::chrono::milliseconds timeout{3000};
};

/// Redis. Any thread may call.
/// Errors, of all that follows: StorageAway where it cannot be reached, or refuses; HttpError
/// (storage-full) where it has no room.
class Redis {
 public:
  /// Connects to nothing yet.
  explicit Redis(RedisOptions options);
  ~Redis();
  Redis(const Redis&) = delete;
  Redis& operator=(const Redis&) = delete;

  /// What it answers. A connection that has been left broken is made anew, once; so what is asked
  /// for may be done twice where an answer has been lost.
  RedisReply call(const std::vector<std::string_view>& words);

  const RedisOptions& options() const { return options_; }
  /// Whether the last call was answered.
  bool is_up() const { return is_up_; }

 private:
  struct Connection;
  friend class RedisChannel;
  std::unique_ptr<Connection> kept();
  std::unique_ptr<Connection> connect() const;
  RedisReply ask(std::unique_ptr<Connection> connection,
                 const std::vector<std::string_view>& words);
  RedisReply answer(const std::vector<std::string_view>& words);

  const RedisOptions options_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Connection>> idle_;
  std::atomic<bool> is_up_ = true;
};

/// RedisScript: one in Lua, which Redis does as one change.
class RedisScript {
 public:
  /// Domain: the text lives as long as this.
  explicit RedisScript(std::string text) : text_(std::move(text)) {}
  /// What it returns, of one key and these arguments. Errors: as Redis::call.
  RedisReply run(Redis& redis, std::string_view key, const std::vector<std::string>& arguments);

 private:
  const std::string text_;
  std::mutex mutex_;
  std::string sha1_;  // by which Redis knows it, once it does
};

/// RedisChannel: a thread that listens to what is published there.
class RedisChannel {
 public:
  using Heard = std::function<void(const std::string&)>;

  /// `heard` is told of each message, `joined` whenever it listens (again): what was published
  /// before then may have been missed. Both are called on its thread and must not throw.
  RedisChannel(Redis& redis, std::string name, Heard heard, std::function<void()> joined);
  ~RedisChannel();
  RedisChannel(const RedisChannel&) = delete;
  RedisChannel& operator=(const RedisChannel&) = delete;

 private:
  void listen(const std::stop_token& stop);
  void listen_once(const std::stop_token& stop);

  Redis& redis_;
  const std::string name_;
  const Heard heard_;
  const std::function<void()> joined_;
  std::jthread thread_;
};

}  // namespace tia::server
