#include "server/http/proxies.h"

#include <asio/ip/address.hpp>
#include <string_view>

namespace tia::server {
namespace {

bool has_form_of_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == text.npos;
}

bool is_v4(std::string_view text) {
  asio::error_code error;
  asio::ip::make_address_v4(text, error);
  return !error;
}

// Without a zone ("%eth0"), which means an interface of the proxy's machine, and may be any text.
bool is_v6(std::string_view text) {
  asio::error_code error;
  asio::ip::make_address_v6(text, error);
  return !error && text.find('%') == text.npos;
}

// The address in 1.2.3.4, 1.2.3.4:5, 2001:db8::1, [2001:db8::1] and [2001:db8::1]:5, some of which
// proxies write against all custom; "" where there is none.
std::string_view address_in(std::string_view text) {
  if (is_v4(text) || is_v6(text)) return text;
  const std::size_t end = text.find_last_of("]:");
  if (end == text.npos) return {};
  const bool has_port = text[end] == ':';
  if (has_port && !has_form_of_port(text.substr(end + 1))) return {};
  if (!has_port && end + 1 < text.size()) return {};
  const std::string_view host = text.substr(0, has_port ? end : end + 1);
  if (is_v4(host)) return host;
  const bool in_brackets = host.starts_with('[') && host.ends_with(']');
  const std::string_view inner = in_brackets ? host.substr(1, host.size() - 2) : host;
  return in_brackets && is_v6(inner) ? inner : std::string_view();
}

// Takes the last entry off a list parted by commas.
std::string take_last(std::string& list) {
  const auto comma = list.rfind(',');
  std::string last(trimmed(std::string_view(list).substr(comma + 1)));
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
    const std::string_view address = address_in(before);
    if (address.empty()) break;
    client = address;
  }
  return client;
}

}  // namespace tia::server
