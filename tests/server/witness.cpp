#include "tests/server/witness.h"

#include <algorithm>
#include <mutex>
#include <set>

#include "server/contract/problem.h"
#include "server/http/chunks.h"
#include "tests/server/contract/contract.h"

namespace tia::test {
namespace {

using server::Headers;
using server::Request;
using server::Response;

std::mutex ports_mutex;
std::multiset<int> service_ports;

constexpr std::string_view head_end = "\r\n\r\n";

// The header fields after a first line. Those of a request may be anything.
Headers fields_of(std::string_view head) {
  Headers headers;
  for (std::size_t line = head.find("\r\n"); line != head.npos;
       line = head.find("\r\n", line + 2)) {
    const std::string_view field = head.substr(line + 2, head.find("\r\n", line + 2) - line - 2);
    const std::size_t colon = field.find(':');
    if (colon != field.npos)
      headers.emplace_back(field.substr(0, colon), server::trimmed(field.substr(colon + 1)));
  }
  return headers;
}

std::string field(const Headers& headers, std::string_view name) {
  for (const auto& [key, value] : headers)
    if (server::same_word(key, name)) return value;
  return "";
}

std::size_t length_of(const Headers& headers) {
  const std::string text = field(headers, "Content-Length");
  const bool digits =
      !text.empty() && text.size() < 10 &&
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return digits ? std::stoul(text) : 0;
}

}  // namespace

ServicePort::ServicePort(int port) : port_(port) {
  const std::lock_guard lock(ports_mutex);
  service_ports.insert(port_);
}
ServicePort::~ServicePort() {
  const std::lock_guard lock(ports_mutex);
  service_ports.erase(service_ports.find(port_));
}

std::optional<Response> take_answer(std::string& bytes, bool to_head) {
  const std::size_t end = bytes.find(head_end);
  if (end == bytes.npos) return std::nullopt;
  const std::string_view head = std::string_view(bytes).substr(0, end);
  Response response;
  response.headers = fields_of(head);
  response.status = std::stoi(std::string(head.substr(head.find(' '))));
  response.content_type = field(response.headers, "Content-Type");
  const std::size_t from = end + head_end.size();
  if (!to_head && field(response.headers, "Transfer-Encoding") == "chunked") {
    server::ChunkDecoder decoder({1 << 30});
    std::string_view chunks = std::string_view(bytes).substr(from);
    if (!decoder.decode(chunks, response.body)) return std::nullopt;
    bytes.erase(0, bytes.size() - chunks.size());
    return response;
  }
  const std::size_t length = to_head ? 0 : length_of(response.headers);
  if (bytes.size() < from + length) return std::nullopt;
  response.body = bytes.substr(from, length);
  bytes.erase(0, from + length);
  return response;
}

Witness::Witness(int port) {
  const std::lock_guard lock(ports_mutex);
  watches_ = service_ports.contains(port);
}

void Witness::sent(std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  if (watches_) reader_.feed(bytes);
}

void Witness::received(std::string_view bytes) {
  const std::lock_guard lock(mutex_);
  if (!watches_) return;
  received_.append(bytes);
  for (;;) {
    if (!asked_) read_request();
    const Request request =
        asked_ ? *asked_ : reader_.request();  // which is answered before it ends
    const auto response = take_answer(received_, request.is_head());
    if (!response) return;
    if (response->status < 200) continue;
    expect_allowed(request, *response);
    asked_.reset();
  }
}

void Witness::read_request() {
  try {
    if (readable_ && reader_.read() == server::RequestReader::State::whole) asked_ = reader_.take();
  } catch (const server::HttpError&) {
    readable_ = false;
  }
}

}  // namespace tia::test
