// SHA-256, by OpenSSL.
#pragma once

#include <string>
#include <string_view>

namespace tia::server {

/// Returns: 64 hexadecimal digits. Source: FIPS 180-4.
std::string sha256_hex(std::string_view bytes);

}  // namespace tia::server
