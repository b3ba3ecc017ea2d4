#include "server/stores/digest.h"

#include <openssl/sha.h>

#include <new>

namespace tia::server {

std::string hex(const Digest& digest) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}

std::string sha256_hex(std::string_view bytes) {
  Digest digest{};
  static_assert(SHA256_DIGEST_LENGTH == digest.size());
  if (SHA256(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), digest.data()) ==
      nullptr)
    throw std::bad_alloc();
  return hex(digest);
}

}  // namespace tia::server
