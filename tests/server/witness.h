// Watches connections to the service, and judges every whole answer by the OpenAPI document.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/request_reader.h"

namespace tia::test {

/// ServicePort: while one lives, what comes from that port of this machine is the service's.
class ServicePort {
 public:
  explicit ServicePort(int port);
  ~ServicePort();
  ServicePort(const ServicePort&) = delete;
  ServicePort& operator=(const ServicePort&) = delete;

 private:
  const int port_;
};

/// Takes the first answer off the bytes; nothing where it is not whole. One to HEAD has no body.
std::optional<server::Response> take_answer(std::string& bytes, bool to_head = false);

/// Witness: of one connection, which matters if it leads to a ServicePort. Two threads may tell it.
class Witness {
 public:
  explicit Witness(int port);
  /// Before it is sent, or the answer could come first.
  void sent(std::string_view bytes);
  void received(std::string_view bytes);

 private:
  static constexpr std::int64_t any_length = 1 << 30;
  void read_request();

  std::mutex mutex_;
  bool watches_ = false;
  bool readable_ = true;  // what was sent is so far no more than requests
  server::RequestReader reader_{any_length};
  std::optional<server::Request> asked_;
  std::string received_;
};

}  // namespace tia::test
