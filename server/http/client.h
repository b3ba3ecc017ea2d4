// Requests to a server elsewhere, for the command line.
#pragma once

#include <string>

#include "server/http/message.h"

namespace tia::server {

/// Client: asks one server, a request at a time.
class Client {
 public:
  /// `url`: "http://host:port". Errors: std::invalid_argument for what is none.
  explicit Client(std::string url);
  /// The answer's status, type, body and fields. Errors: std::runtime_error where none comes.
  Response ask(const std::string& method, const std::string& path, const std::string& body = "",
               const Headers& headers = {}) const;

 private:
  std::string url_;
};

}  // namespace tia::server
