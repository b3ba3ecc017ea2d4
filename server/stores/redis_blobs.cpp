// Blobs in a farm's own Redis, where there is no other place for them: keys of its memory, which
// end where nobody has taken them for good (PERSIST) within ten minutes.
#include "server/contract/problem.h"
#include "server/stores/blobs.h"

namespace tia::server {
namespace {

class RedisBlobs : public Blobs {
 public:
  RedisBlobs(Redis& redis, std::string prefix) : redis_(redis), prefix_(std::move(prefix)) {}

  void put(const std::string& name, std::string_view bytes) override {
    redis_.call({"SET", prefix_ + name, bytes, "EX", "600"});
  }
  std::optional<std::string> find(const std::string& name) override {
    RedisReply bytes = redis_.call({"GET", prefix_ + name});
    if (bytes.kind != RedisReply::text) return std::nullopt;
    return std::move(bytes.words);
  }
  void remove(const std::string& name) override { redis_.call({"UNLINK", prefix_ + name}); }
  std::vector<std::string> names(const std::string&) override {
    throw StorageError("a Redis does not list blobs");  // KEYS would keep all others waiting
  }

 private:
  Redis& redis_;
  const std::string prefix_;
};

}  // namespace

std::unique_ptr<Blobs> blobs_in_redis(Redis& redis, const std::string& prefix) {
  return std::make_unique<RedisBlobs>(redis, prefix);
}

}  // namespace tia::server
