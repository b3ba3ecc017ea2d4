#include "server/http/peers.h"

#include <arpa/inet.h>

#include <algorithm>
#include <charconv>

namespace tia::server {
namespace {

using Address = std::array<unsigned char, 16>;
constexpr int mapped_bits = 96;  // what comes before an IPv4 address among those of IPv6

// An IPv6 zone ("fe80::1%eth0") says through which interface a packet came, not from whom.
std::optional<Address> address_of(const std::string& text) {
  Address address{};
  const std::string plain = text.substr(0, text.find('%'));
  if (inet_pton(AF_INET6, plain.c_str(), address.data()) == 1) return address;
  if (inet_pton(AF_INET, plain.c_str(), &address[12]) != 1) return std::nullopt;
  address[10] = address[11] = 0xFF;
  return address;
}

std::optional<int> bits_of(std::string_view text, int most) {
  int bits = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bits);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  if (bits < 0 || bits > most || std::to_string(bits) != text) return std::nullopt;
  return bits;
}

// The address with all bits beyond the prefix cleared.
Address start_of(Address address, int prefix) {
  for (int i = 0; i < 16; ++i) {
    const int kept = std::clamp(prefix - 8 * i, 0, 8);
    auto& byte = address[static_cast<std::size_t>(i)];
    byte = static_cast<unsigned char>(byte & (0xFF00 >> kept));
  }
  return address;
}

bool is_real_port(std::string_view text) {
  const auto port = bits_of(text, 65535);
  return port && *port > 0;
}

}  // namespace

std::optional<Origin> Origin::parse(const std::string& text) {
  if (text == "*") return Origin{text};
  const std::string_view all = text;
  const bool secure = all.starts_with("https://");
  if (!secure && !all.starts_with("http://")) return std::nullopt;
  const std::string_view place = all.substr(secure ? 8 : 7);
  const std::size_t bracket = place.find(']');  // the end of an IPv6 address
  const std::size_t colon = place.find(':', bracket == place.npos ? 0 : bracket);
  const std::string_view host = place.substr(0, colon);
  const auto fit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
           std::string_view("-._[]:").find(c) != std::string_view::npos;
  };
  if (host.empty() || !std::all_of(host.begin(), host.end(), fit)) return std::nullopt;
  if (colon == place.npos) return Origin{text};
  const std::string_view port = place.substr(colon + 1);
  const bool silent = port == (secure ? "443" : "80");  // which browsers leave out
  return is_real_port(port) && !silent ? std::optional(Origin{text}) : std::nullopt;
}

std::optional<HostName> HostName::parse(const std::string& text) {
  const auto fit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-._").find(c) != std::string_view::npos;
  };
  if (text == "*") return HostName{text};
  const bool in_brackets = text.starts_with('[') && text.ends_with(']');
  if (in_brackets && address_of(text.substr(1, text.size() - 2))) return HostName{text};
  if (text.empty() || !std::all_of(text.begin(), text.end(), fit)) return std::nullopt;
  return HostName{text};
}

std::optional<Network> Network::parse(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string start = text.substr(0, slash);
  const auto address = address_of(start);
  if (!address || start.find('%') != start.npos) return std::nullopt;
  const int before = start.find(':') == start.npos ? mapped_bits : 0;
  int prefix = 128;
  if (slash != text.npos) {
    const auto bits = bits_of(std::string_view(text).substr(slash + 1), 128 - before);
    if (!bits) return std::nullopt;
    prefix = before + *bits;
  }
  if (start_of(*address, prefix) != *address) return std::nullopt;
  return Network{text, *address, prefix};
}

bool Network::contains(const std::string& peer) const {
  const auto is = address_of(peer);
  return is && start_of(*is, prefix) == address;
}

std::string share_of(const std::string& address) {
  const auto is = address_of(address);
  if (!is) return address;
  const bool mapped = start_of(*is, mapped_bits) == *address_of("::ffff:0.0.0.0");
  const Address start = mapped ? *is : start_of(*is, 64);
  char text[INET6_ADDRSTRLEN] = {};
  inet_ntop(AF_INET6, start.data(), text, sizeof text);
  return text;
}

}  // namespace tia::server
