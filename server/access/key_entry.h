// A key as its file has it (TIA_KEYS_FILE): who it is, what it may do, and how much.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/input/codec.h"
#include "server/contract/rights.h"
#include "server/http/peers.h"

namespace tia::server {

/// KeyId: what a key is called by, in logs and metrics, too.
struct KeyId {
  static constexpr const char* form =
      "1 to 64 letters, digits, - and _, but not other, which metrics call all beyond a hundred";
  std::string text;
  static std::optional<KeyId> parse(const std::string& text);
  bool operator==(const KeyId&) const = default;
};

/// UtcTime. Source: RFC 3339, 5.6, of which this is one spelling.
struct UtcTime {
  static constexpr const char* form = "a time in UTC such as 2031-01-31T23:59:59Z";
  std::string text;
  std::int64_t seconds = 0;  ///< since 1970
  static std::optional<UtcTime> parse(const std::string& text);
  bool operator==(const UtcTime&) const = default;
};

/// KeyPriority: of jobs.
enum class KeyPriority { low, normal, high };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::KeyPriority> {
  static constexpr std::array<std::string_view, 3> names{"low", "normal", "high"};
};

namespace tia::server {

struct KeyEntry {
  /// The entry of this id is for whoever comes without a key.
  static constexpr std::string_view anonymous = "anonymous";
  /// What structured fields can tell, a trillion requests a day and more. Source: RFC 8941, 3.3.1.
  static constexpr double most = 999'999'999'999'999;

  KeyId id;
  std::optional<std::string> sha256;
  std::vector<Right> may;
  std::optional<double> requests_per_s;
  std::optional<int> burst;
  std::optional<std::int64_t> rays_per_day;
  std::optional<int> jobs;
  std::optional<std::int64_t> kept_bytes;
  KeyPriority priority = KeyPriority::normal;
  std::optional<UtcTime> expires;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("id", &KeyEntry::id,
          Spec{.about = "what the key is called; anonymous: whoever comes without one",
               .required = true});
    visit("sha256", &KeyEntry::sha256,
          Spec{.about = "the SHA-256 of its secret, 64 hexadecimal digits, a to f small"});
    visit("may", &KeyEntry::may, Spec{.about = "what it may do", .required = true});
    visit("requests_per_s", &KeyEntry::requests_per_s,
          Spec{.about = "how many requests it may make in the long run; without: any number",
               .unit = "requests a second",
               .min = 0.001,
               .max = 1e6});
    visit("burst", &KeyEntry::burst,
          Spec{.about = "how many of them at once; without: those of a second, at least one",
               .unit = "requests",
               .min = 1,
               .max = 1e6});
    visit(
        "rays_per_day", &KeyEntry::rays_per_day,
        Spec{.about = "rays that may be traced for it from 0:00 to 24:00 UTC; without: any number",
             .unit = "rays",
             .min = 1,
             .max = most});
    visit("jobs", &KeyEntry::jobs,
          Spec{.about = "unfinished jobs that it may have; without: any number",
               .min = 0,
               .max = 1e6});
    visit("kept_bytes", &KeyEntry::kept_bytes,
          Spec{.about = "what of its may be kept; without: any number",
               .unit = "bytes",
               .min = 0,
               .max = most});
    visit("priority", &KeyEntry::priority, Spec{.about = "that its jobs have at most"});
    visit("expires", &KeyEntry::expires, Spec{.about = "when it ends; without: never"});
  }

  /// What is no SHA-256, which is not told: it may be the secret; one of anonymous, none of
  /// another; a burst without a rate.
  void check(const Place& at, Faults& faults) const;
  bool is_anonymous() const { return id.text == anonymous; }
  bool has(Right right) const;
};

}  // namespace tia::server
