#include "server/stores/redis.h"

#include <condition_variable>
#include <optional>
#include <stdexcept>

#include "server/contract/problem.h"

namespace tia::server {
namespace {

using RedisClock = std::chrono::steady_clock;

constexpr std::size_t most_idle_connections = 16;
constexpr std::chrono::milliseconds between_joins{200};
constexpr std::chrono::milliseconds longest_silence{5000};

// An answer that is an error, as what it means to us.
[[noreturn]] void refuse_reply(const std::string& words) {
  if (words.starts_with("OOM"))
    throw HttpError("storage-full", "the farm's Redis has no room (its option maxmemory)");
  throw StorageAway("Redis: " + words);
}

}  // namespace

// A socket that has logged in, and how far its answers are read.
struct Redis::Connection {
  RedisSocket socket;
  RedisReader reader = {};

  RedisReply ask(const std::vector<std::string_view>& words, RedisSocket::Deadline until) {
    socket.write(redis_command(words), until);
    if (auto reply = next(until)) return std::move(*reply);
    throw StorageAway("Redis: no answer in time");
  }
  std::optional<RedisReply> next(RedisSocket::Deadline until) {
    for (;;) {
      if (auto reply = reader.next()) return reply;
      const std::string_view more = socket.read(until);
      if (more.empty()) return std::nullopt;
      reader.feed(more);
    }
  }
};

Redis::Redis(RedisOptions options) : options_(std::move(options)) {}
Redis::~Redis() = default;

std::unique_ptr<Redis::Connection> Redis::connect() const {
  const RedisAddress& at = options_.at;
  const auto until = RedisClock::now() + options_.timeout;
  std::unique_ptr<Connection> made(
      new Connection{RedisSocket(at.host, at.port, at.is_tls, options_.ca_file, until)});
  const auto require = [&](const std::vector<std::string_view>& words) {
    if (const RedisReply reply = made->ask(words, until); reply.kind == RedisReply::error)
      throw StorageAway("Redis: " + reply.words);
  };
  if (!at.user.empty()) require({"AUTH", at.user, options_.password});
  else if (!options_.password.empty()) require({"AUTH", options_.password});
  if (at.database != 0) require({"SELECT", std::to_string(at.database)});
  return made;
}

std::unique_ptr<Redis::Connection> Redis::kept() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return nullptr;
  std::unique_ptr<Connection> connection = std::move(idle_.back());
  idle_.pop_back();
  return connection;
}

RedisReply Redis::ask(std::unique_ptr<Connection> connection,
                      const std::vector<std::string_view>& words) {
  RedisReply reply = connection->ask(words, RedisClock::now() + options_.timeout);
  const std::lock_guard lock(mutex_);
  if (idle_.size() < most_idle_connections) idle_.push_back(std::move(connection));
  return reply;
}

RedisReply Redis::answer(const std::vector<std::string_view>& words) {
  if (auto connection = kept()) {
    try {
      return ask(std::move(connection), words);
    } catch (const StorageAway&) {
      throw;  // it is there, but silent
    } catch (const std::runtime_error&) {
      // Redis may have been started anew: then all that are kept are as broken.
      const std::lock_guard lock(mutex_);
      idle_.clear();
    }
  }
  return ask(connect(), words);
}

RedisReply Redis::call(const std::vector<std::string_view>& words) {
  RedisReply reply;
  try {
    reply = answer(words);
  } catch (const StorageAway&) {
    is_up_ = false;
    throw;
  } catch (const std::runtime_error& error) {
    is_up_ = false;
    throw StorageAway("Redis at " + options_.at.host + ": " + error.what());
  }
  is_up_ = true;
  if (reply.kind == RedisReply::error && !reply.words.starts_with("NOSCRIPT"))
    refuse_reply(reply.words);
  return reply;
}

// ---- scripts --------------------------------------------------------------------------------

RedisReply RedisScript::run(Redis& redis, std::string_view key,
                            const std::vector<std::string>& arguments) {
  const auto known = [&] {
    const std::lock_guard lock(mutex_);
    return sha1_;
  };
  const auto load = [&] {
    const std::lock_guard lock(mutex_);
    return sha1_ = redis.call({"SCRIPT", "LOAD", text_}).words;
  };
  std::string sha1 = known();
  if (sha1.empty()) sha1 = load();
  std::vector<std::string_view> words{"EVALSHA", sha1, "1", key};
  words.insert(words.end(), arguments.begin(), arguments.end());
  RedisReply reply = redis.call(words);
  if (reply.kind != RedisReply::error) return reply;
  words[0] = "EVAL";  // a Redis that has been started anew, or is another
  words[1] = text_;
  return redis.call(words);
}

// ---- channels -------------------------------------------------------------------------------

RedisChannel::RedisChannel(Redis& redis, std::string name, Heard heard,
                           std::function<void()> joined)
    : redis_(redis),
      name_(std::move(name)),
      heard_(std::move(heard)),
      joined_(std::move(joined)),
      thread_([this](const std::stop_token& stop) { listen(stop); }) {}
RedisChannel::~RedisChannel() = default;

void RedisChannel::listen(const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any ended;
  while (!stop.stop_requested()) {
    try {
      listen_once(stop);
    } catch (const std::exception&) {  // the calls tell what is wrong
    }
    std::unique_lock lock(mutex);
    ended.wait_for(lock, stop, between_joins, [] { return false; });
  }
}

void RedisChannel::listen_once(const std::stop_token& stop) {
  const auto connection = redis_.connect();
  const std::stop_callback leave(stop, [&] { connection->socket.interrupt(); });
  connection->ask({"SUBSCRIBE", name_}, RedisClock::now() + redis_.options().timeout);
  joined_();
  bool is_asked = false;  // whether it is still there
  while (!stop.stop_requested()) {
    const auto reply = connection->next(RedisClock::now() + longest_silence);
    if (!reply && is_asked) return;
    is_asked = !reply;
    if (is_asked)
      connection->socket.write(redis_command({"PING"}), RedisClock::now() + longest_silence);
    else if (reply->items.size() == 3 && reply->items[0].words == "message")
      heard_(reply->items[2].words);
  }
}

}  // namespace tia::server
