#include "server/stores/digest.h"

#include <openssl/evp.h>

#include <algorithm>
#include <memory>
#include <new>

#include "core/parallel/stopped.h"

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
  constexpr std::size_t portion = 1 << 20;
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  const std::unique_ptr<EVP_MD_CTX, Free> context(EVP_MD_CTX_new());
  Digest digest{};
  bool done = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  for (; done && !bytes.empty(); bytes.remove_prefix(std::min(portion, bytes.size()))) {
    give_way();
    const std::string_view next = bytes.substr(0, portion);
    done = EVP_DigestUpdate(context.get(), next.data(), next.size()) == 1;
  }
  // It fails for want of memory only.
  if (!done || EVP_DigestFinal_ex(context.get(), digest.data(), nullptr) != 1)
    throw std::bad_alloc();
  return hex(digest);
}

}  // namespace tia::server
