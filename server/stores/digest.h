// SHA-256 and codes by it, by OpenSSL.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace tia::server {

/// Digest: SHA-256. Whoever posts scenes cannot make two of the same.
using Digest = std::array<std::uint8_t, 32>;

/// 64 hexadecimal digits.
std::string hex(const Digest& digest);

/// Sha256: of bytes that come one after the other. Source: FIPS 180-4.
class Sha256 {
 public:
  /// Errors: std::bad_alloc.
  Sha256();
  ~Sha256();
  Sha256(const Sha256&) = delete;
  Sha256& operator=(const Sha256&) = delete;
  /// Errors: std::bad_alloc.
  void add(std::string_view bytes);
  /// 64 hexadecimal digits, once all has been added. Errors: std::bad_alloc.
  std::string digits();

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// A code of the text that only who has the key can make. Errors: std::bad_alloc.
/// Source: RFC 2104, with SHA-256.
Digest hmac_sha256(std::string_view key, std::string_view text);

/// Returns: the digest's digits. Source: FIPS 180-4.
std::string sha256_hex(std::string_view bytes);

}  // namespace tia::server
