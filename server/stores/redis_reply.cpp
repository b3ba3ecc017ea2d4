#include "server/stores/redis_reply.h"

#include <hiredis/hiredis.h>

#include <new>
#include <stdexcept>

namespace tia::server {
namespace {

// Depth: at most 7, which the reader sees to.
// NOLINTNEXTLINE(misc-no-recursion)
RedisReply reply_of(const redisReply& read) {
  RedisReply reply;
  switch (read.type) {
    case REDIS_REPLY_STRING:
    case REDIS_REPLY_STATUS:
    case REDIS_REPLY_ERROR:
      reply.kind = read.type == REDIS_REPLY_ERROR ? RedisReply::error : RedisReply::text;
      reply.words.assign(read.str, read.len);
      break;
    case REDIS_REPLY_INTEGER:
      reply.kind = RedisReply::number;
      reply.count = read.integer;
      break;
    case REDIS_REPLY_ARRAY:
      reply.kind = RedisReply::list;
      reply.items.reserve(read.elements);
      for (std::size_t i = 0; i < read.elements; ++i)
        reply.items.push_back(reply_of(*read.element[i]));
      break;
    default: break;
  }
  return reply;
}

void require_read(const redisReader& reader, int status) {
  if (status == REDIS_OK) return;
  if (reader.err == REDIS_ERR_OOM) throw std::bad_alloc();
  throw std::runtime_error(reader.errstr);
}

}  // namespace

std::string redis_command(const std::vector<std::string_view>& words) {
  std::vector<const char*> starts;
  std::vector<std::size_t> lengths;
  for (const std::string_view word : words) {
    starts.push_back(word.data());
    lengths.push_back(word.size());
  }
  char* bytes = nullptr;
  const int length =
      redisFormatCommandArgv(&bytes, static_cast<int>(words.size()), starts.data(), lengths.data());
  if (length < 0) throw std::bad_alloc();
  const std::unique_ptr<char, void (*)(char*)> owned(bytes, redisFreeCommand);
  return {bytes, static_cast<std::size_t>(length)};
}

void RedisReader::Free::operator()(redisReader* reader) const { redisReaderFree(reader); }

RedisReader::RedisReader() : reader_(redisReaderCreate()) {
  if (!reader_) throw std::bad_alloc();
}

void RedisReader::feed(std::string_view bytes) {
  require_read(*reader_, redisReaderFeed(reader_.get(), bytes.data(), bytes.size()));
}

std::optional<RedisReply> RedisReader::next() {
  void* read = nullptr;
  require_read(*reader_, redisReaderGetReply(reader_.get(), &read));
  if (read == nullptr) return std::nullopt;
  const std::unique_ptr<void, void (*)(void*)> owned(read, freeReplyObject);
  return reply_of(*static_cast<const redisReply*>(read));
}

}  // namespace tia::server
