#include "server/stores/redis_address.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace tia::server {
namespace {

constexpr int most_port = 65'535;
constexpr int most_database = 15;

[[noreturn]] void refuse_url(const std::string& what) {
  throw std::invalid_argument(what + ", allowed: " + std::string(allowed_redis_url));
}

bool is_plain(std::string_view text, std::string_view more) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           more.find(c) != more.npos;
  });
}

// Digits alone, in that range.
int number_in(std::string_view text, int least, int most, const char* what) {
  int number = -1;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (!is_plain(text, "") || error != std::errc{} || stop != end || number < least || number > most)
    refuse_url("a " + std::string(what) + " from " + std::to_string(least) + " to " +
               std::to_string(most));
  return number;
}

// Takes what stands before the first `end` off the text; all where there is none.
std::string_view take_until(std::string_view& text, std::string_view end) {
  const std::string_view taken = text.substr(0, text.find(end));
  text.remove_prefix(std::min(text.size(), taken.size() + end.size()));
  return taken;
}

// RFC 3986, 3.2.2.
std::string take_host(std::string_view& authority) {
  if (!authority.starts_with('[')) {
    const auto host = authority.substr(0, authority.find(':'));
    authority.remove_prefix(host.size());
    if (!is_plain(host, ".-_")) refuse_url("a host's name or address");
    return std::string(host);
  }
  authority.remove_prefix(1);
  if (authority.find(']') == authority.npos) refuse_url("a bracket that is closed");
  const auto host = take_until(authority, "]");
  if (!is_plain(host, ".:")) refuse_url("an IPv6 address in the brackets");
  return std::string(host);
}

}  // namespace

RedisAddress read_redis_url(std::string_view url) {
  RedisAddress address;
  const std::string_view scheme = take_until(url, "://");
  if (scheme != "redis" && scheme != "rediss") refuse_url("redis:// or rediss:// at the start");
  address.is_tls = scheme == "rediss";
  const bool has_path = url.find('/') != url.npos;
  std::string_view authority = take_until(url, "/");
  if (authority.find('@') != authority.npos) {
    const std::string_view user = take_until(authority, "@");
    if (!is_plain(user, ".-_")) refuse_url("a user's name of letters, digits, '.', '-', '_'");
    address.user = user;
  }
  address.host = take_host(authority);
  if (authority.starts_with(':'))
    address.port = number_in(authority.substr(1), 1, most_port, "port");
  else if (!authority.empty()) refuse_url("a port after the host");
  if (has_path && !url.empty()) address.database = number_in(url, 0, most_database, "database");
  return address;
}

}  // namespace tia::server
