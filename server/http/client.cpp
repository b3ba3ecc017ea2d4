#include "server/http/client.h"

#include <httplib.h>

#include <stdexcept>

namespace tia::server {

namespace {
constexpr int connect_s = 5;
}  // namespace

Client::Client(std::string url, std::chrono::seconds patience)
    : url_(std::move(url)), patience_(patience) {
  while (url_.ends_with('/')) url_.pop_back();
  if (!url_.starts_with("http://") && !url_.starts_with("https://"))
    throw std::invalid_argument("option --url: got " + url_ + ", allowed: http://HOST:PORT");
}

Response Client::ask(const std::string& method, const std::string& path, const std::string& body,
                     const Headers& headers) const {
  httplib::Client client(url_);
  client.set_connection_timeout(connect_s);
  client.set_read_timeout(patience_);
  client.set_write_timeout(patience_);
  httplib::Request request;
  request.method = method;
  request.path = path;
  request.body = body;
  for (const auto& [name, value] : headers) request.set_header(name, value);
  if (!body.empty() && !request.has_header("Content-Type"))
    request.set_header("Content-Type", "application/json");
  const auto answer = client.send(request);
  if (!answer)
    throw std::runtime_error(url_ + " does not answer: " + httplib::to_string(answer.error()));
  Response response{.status = answer->status,
                    .content_type = answer->get_header_value("Content-Type"),
                    .body = answer->body};
  response.headers.assign(answer->headers.begin(), answer->headers.end());
  return response;
}

}  // namespace tia::server
