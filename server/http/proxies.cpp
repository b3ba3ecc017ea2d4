#include "server/http/proxies.h"

#include <asio/ip/address.hpp>

namespace tia::server {
namespace {

bool is_address(const std::string& text) {
  asio::error_code error;
  asio::ip::make_address(text, error);
  return !error;
}

// Takes the last entry off a list parted by commas.
std::string take_last(std::string& list) {
  const auto comma = list.rfind(',');
  const std::string last(trimmed(std::string_view(list).substr(comma + 1)));
  list.resize(comma == list.npos ? 0 : comma);
  return last;
}

}  // namespace

std::string client_address(const std::string& peer, const Headers& headers,
                           const TrustsProxy& trusts) {
  if (!trusts(peer)) return peer;
  std::string told;
  for (const auto& [name, value] : headers)
    if (same_word(name, "X-Forwarded-For")) told += ',' + value;
  std::string client = peer;
  while (!told.empty() && trusts(client)) {
    const std::string before = take_last(told);
    if (!is_address(before)) break;
    client = before;
  }
  return client;
}

}  // namespace tia::server
