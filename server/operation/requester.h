// Requester: whom a request is from, and until when.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>

namespace tia::server {

struct Requester {
  std::string client;  ///< by which clients are told apart
  std::stop_token stop;
  std::string key = {};  ///< who pays for its rays; "" = whoever has no key

  std::uint64_t number() const { return std::hash<std::string>{}(client); }
};

}  // namespace tia::server
