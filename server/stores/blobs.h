// Blobs: long bytes by name, for all machines of a farm: results of jobs, models, scenes. A closed
// list of places, a file each: a folder (dir:/path), S3 (s3://bucket/prefix), a Redis.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/error.h"
#include "server/stores/redis.h"

namespace tia::server {

/// Blobs. Any thread may call. Names are letters, digits, '-', '_', '.' and '/'; none is given to
/// other bytes than it had.
/// Errors, of all that follows: StorageAway where the place cannot be reached, or fails, also when
/// it is asked again; StorageError where it refuses; HttpError (storage-full).
class Blobs {
 public:
  Blobs() = default;
  Blobs(const Blobs&) = delete;
  Blobs& operator=(const Blobs&) = delete;
  virtual ~Blobs() = default;

  /// All of it is there, whatever ends next, when this returns; or nothing by that name.
  virtual void put(const std::string& name, std::string_view bytes) = 0;
  /// What has that name, whatever it is by now; none where there is none.
  virtual std::optional<std::string> find(const std::string& name) = 0;
  /// One that is not there is none the less gone.
  virtual void remove(const std::string& name) = 0;
  /// Those whose names begin so. Domain: the prefix ends in '/'.
  virtual std::vector<std::string> names(const std::string& prefix) = 0;
};

/// The bytes of that name where their SHA-256 is that; what comes otherwise is asked for again, and
/// none where it stays so, or is not there.
std::optional<std::string> checked_blob(Blobs& blobs, const std::string& name,
                                        std::string_view sha256);

/// S3Options: how the store of an s3:// URL is reached, by its option's name.
struct S3Options {
  std::string endpoint = {};  ///< "https://host[:port]"; "": AWS' own of the region
  std::string region = "us-east-1";
  std::string key_id = {}, key_secret = {};
};

/// What such a place looks like.
constexpr std::string_view allowed_store =
    "dir:/PATH, a folder that is there, or s3://BUCKET[/PREFIX]";

/// The place of a URL. Errors: std::invalid_argument that says what is wrong.
std::unique_ptr<Blobs> blobs_at(const std::string& url, const S3Options& s3);

// The places, in their files.
/// Errors: std::invalid_argument for one that is no folder that can be written to.
std::unique_ptr<Blobs> blobs_in_folder(const std::string& path);
/// `prefix`: "" or such that a '/' comes next.
std::unique_ptr<Blobs> blobs_in_s3(const std::string& bucket, const std::string& prefix,
                                   const S3Options& options);
/// As keys that begin so, which end by themselves unless somebody persists them; it knows no
/// names(). Domain: the Redis outlives them.
std::unique_ptr<Blobs> blobs_in_redis(Redis& redis, const std::string& prefix);

/// What is thrown where a place has no room.
HttpError store_full();

}  // namespace tia::server
