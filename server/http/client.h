// Requests to a server elsewhere, for the command line.
#pragma once

#include <chrono>
#include <string>

#include "server/http/message.h"

namespace tia::server {

/// Client: asks one server, a request at a time.
class Client {
 public:
  /// `url`: "http://host:port". `patience`: how long each piece of an answer may take; the default
  /// is longer than any `Prefer: wait`. Errors: std::invalid_argument for what is none.
  explicit Client(std::string url, std::chrono::seconds patience = std::chrono::seconds(75));
  /// The answer's status, type, body and fields. A body is JSON where the fields do not say what it
  /// is. Errors: std::runtime_error where none comes.
  Response ask(const std::string& method, const std::string& path, const std::string& body = "",
               const Headers& headers = {}) const;

 private:
  std::string url_;
  std::chrono::seconds patience_;
};

}  // namespace tia::server
