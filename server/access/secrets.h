// Cryptography of keys and signatures, by OpenSSL: nothing here is of our own making.
#pragma once

#include <string>
#include <string_view>

namespace tia::server {

/// base64url(HMAC-SHA256(key, text)): 43 characters. Errors: std::bad_alloc.
/// Source: RFC 2104; FIPS 180-4; RFC 4648, 5, without padding.
std::string authentication_code(std::string_view key, std::string_view text);

/// Whether two texts are the same, in a time that tells nothing but whether their lengths are.
bool same_secret(std::string_view a, std::string_view b);

/// 256 bits of the system's randomness as base64url, 43 characters.
/// Errors: std::runtime_error where there are none.
std::string random_secret();

}  // namespace tia::server
