#include "server/stores/digest.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>

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

struct Sha256::Context {
  struct Free {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> evp{EVP_MD_CTX_new()};
};

namespace {
// OpenSSL fails for want of memory only.
void require_done(bool done) {
  if (!done) throw std::bad_alloc();
}
}  // namespace

Sha256::Sha256() : context_(std::make_unique<Context>()) {
  const auto& evp = context_->evp;
  require_done(evp && EVP_DigestInit_ex(evp.get(), EVP_sha256(), nullptr) == 1);
}
Sha256::~Sha256() = default;

void Sha256::add(std::string_view bytes) {
  require_done(EVP_DigestUpdate(context_->evp.get(), bytes.data(), bytes.size()) == 1);
}

std::string Sha256::digits() {
  Digest digest{};
  require_done(EVP_DigestFinal_ex(context_->evp.get(), digest.data(), nullptr) == 1);
  return hex(digest);
}

Digest hmac_sha256(std::string_view key, std::string_view text) {
  Digest code{};
  unsigned size = 0;
  const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
  require_done(HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()), bytes, text.size(),
                    code.data(), &size) != nullptr);
  return code;
}

std::string sha256_hex(std::string_view bytes) {
  constexpr std::size_t portion = 1 << 20;
  Sha256 hash;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(portion, bytes.size()))) {
    give_way();
    hash.add(bytes.substr(0, portion));
  }
  return hash.digits();
}

}  // namespace tia::server
