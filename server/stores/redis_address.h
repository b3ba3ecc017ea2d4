// redis:// and rediss:// URLs, read strictly.
#pragma once

#include <string>
#include <string_view>

namespace tia::server {

/// RedisAddress: where a Redis is, and as whom it is asked. Its password is in no URL.
/// Source: the schemes `redis` and `rediss` of IANA's list of URI schemes.
struct RedisAddress {
  bool is_tls = false;
  std::string user = {};  ///< of its ACL; "": its default user
  std::string host = {};
  int port = 6379;
  int database = 0;

  bool operator==(const RedisAddress&) const = default;
};

/// What such a URL looks like.
constexpr std::string_view allowed_redis_url =
    "rediss://[USER@]HOST[:PORT][/DATABASE], or redis:// without TLS; no password, which is "
    "TIA_FARM_PASSWORD_FILE's; an IPv6 address in brackets";

/// Errors: std::invalid_argument that says what is wrong.
RedisAddress read_redis_url(std::string_view url);

}  // namespace tia::server
