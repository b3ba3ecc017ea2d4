// What is said to a Redis and what it answers (RESP 2), by hiredis. The only place that includes
// it.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct redisReader;

namespace tia::server {

/// RedisReply: an answer as plain data.
struct RedisReply {
  enum Kind { nothing, text, number, list, error };
  Kind kind = nothing;
  std::string words = {};  ///< of a text or an error
  std::int64_t count = 0;  ///< of a number
  std::vector<RedisReply> items = {};
};

/// A command and its arguments, as they are sent. Errors: std::bad_alloc.
std::string redis_command(const std::vector<std::string_view>& words);

/// RedisReader: answers out of bytes that come in any pieces.
class RedisReader {
 public:
  RedisReader();
  /// Errors: std::bad_alloc; std::runtime_error of what is no answer.
  void feed(std::string_view bytes);
  /// The next one, once it is there whole. Errors: as feed.
  std::optional<RedisReply> next();

 private:
  struct Free {
    void operator()(redisReader* reader) const;
  };
  std::unique_ptr<redisReader, Free> reader_;
};

}  // namespace tia::server
