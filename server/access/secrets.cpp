#include "server/access/secrets.h"

#include <openssl/crypto.h>
#include <sys/random.h>

#include <array>
#include <span>
#include <stdexcept>

#include "server/stores/digest.h"

namespace tia::server {
namespace {

using Bytes = std::array<unsigned char, 32>;

std::string base64url(std::span<const unsigned char> bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::string text;
  unsigned bits = 0;
  int count = 0;  // of those in `bits` that wait
  for (const unsigned char byte : bytes) {
    bits = bits << 8U | byte;
    for (count += 8; count >= 6; count -= 6)
      text += digits[bits >> static_cast<unsigned>(count - 6) & 63U];
  }
  if (count > 0) text += digits[bits << static_cast<unsigned>(6 - count) & 63U];
  return text;
}

}  // namespace

std::string authentication_code(std::string_view key, std::string_view text) {
  return base64url(hmac_sha256(key, text));
}

bool same_secret(std::string_view a, std::string_view b) {
  return a.size() == b.size() && CRYPTO_memcmp(a.data(), b.data(), a.size()) == 0;
}

std::string random_secret() {
  Bytes bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error("the system has no random bytes");
  return base64url(bytes);
}

}  // namespace tia::server
