#include "server/stores/random_key.h"

#include <sys/random.h>

#include <array>

#include "server/contract/problem.h"

namespace tia::server {

std::string random_key() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw StorageError("the system has no random bytes");
  std::string key;
  for (const unsigned char byte : bytes) {
    key += "0123456789abcdef"[byte >> 4U];
    key += "0123456789abcdef"[byte & 15U];
  }
  return key;
}

}  // namespace tia::server
