// Who may ask, as options name them: origins of pages (CORS) and networks of proxies. Each is text
// of a strict form, checked at start.
#pragma once

#include <array>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "core/input/codec.h"

namespace tia::server {

/// Origin: where a page comes from, as browsers send it (RFC 6454, 6.2), or "*" for any.
struct Origin {
  static constexpr const char* form =
      "an origin as browsers send it, such as https://example.org or http://localhost:3000, or *";
  std::string text;

  static std::optional<Origin> parse(const std::string& text);
  bool is_any() const { return text == "*"; }
  bool operator==(const Origin&) const = default;
};

/// Network: all IP addresses that begin with the same bits.
/// Source: RFC 4632, 3.1 (CIDR notation); RFC 4291, 2.5.5.2 (IPv4 addresses among those of IPv6).
struct Network {
  static constexpr const char* form =
      "an IPv4 or IPv6 address or network, such as 10.0.0.0/8 or fd00::1, no bit set beyond the "
      "prefix";
  std::string text;
  std::array<unsigned char, 16> address{};
  int prefix = 128;  ///< bits, of IPv4 networks 96 more than they are written with

  static std::optional<Network> parse(const std::string& text);
  /// Whether an address, as a socket's text has it, belongs to it.
  bool contains(const std::string& peer) const;
  bool operator==(const Network&) const = default;
};

/// HostName: a name that clients call the server by.
struct HostName {
  static constexpr const char* form =
      "a host's name or address without scheme and port, such as tia.example or [::1], or * for "
      "any";
  std::string text;
  static std::optional<HostName> parse(const std::string& text);
  bool operator==(const HostName&) const = default;
};

/// Spelled: text that must have a form.
template <class T>
concept Spelled = requires(const T& t, const std::string& text) {
  { T::parse(text) } -> std::same_as<std::optional<T>>;
  { t.text } -> std::convertible_to<std::string>;
  { T::form } -> std::convertible_to<std::string_view>;
};

/// By what the shares of clients are counted: an address of IPv4, or the /64 of one of IPv6, which
/// is what one customer has.
std::string share_of(const std::string& address);

}  // namespace tia::server

namespace tia {

template <server::Spelled T>
struct Codec<T> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults, T& out) {
    const auto* text = v.as<std::string>();
    if (text == nullptr) return detail::wrong_type(v, at, allowed(spec), faults);
    if (auto is = T::parse(*text)) out = std::move(*is);
    else faults.add({FaultKind::out_of_range, at.pointer(), v, allowed(spec)});
  }
  static Value write(const T& v) { return v.text; }
  static Value schema(const Spec& spec) { return detail::text_schema(spec); }
  static std::string allowed(const Spec&) { return T::form; }
};

}  // namespace tia
