// SHA-256, by OpenSSL.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace tia::server {

/// Digest: SHA-256. Whoever posts scenes cannot make two of the same.
using Digest = std::array<std::uint8_t, 32>;

/// 64 hexadecimal digits.
std::string hex(const Digest& digest);

/// Returns: the digest's digits. Source: FIPS 180-4.
std::string sha256_hex(std::string_view bytes);

}  // namespace tia::server
