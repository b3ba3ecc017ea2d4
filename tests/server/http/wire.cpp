#include "tests/server/http/wire.h"

#include "server/contract/problem.h"
#include "server/operation/log.h"

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <memory>
#include <stdexcept>
#include <utility>

namespace tia::test {

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

HttpOptions any_port() { return {.host = "127.0.0.1", .port = 0}; }

Serving::Serving(Application application, HttpOptions options)
    : http_(std::move(options), std::move(application)),
      running_(std::async(std::launch::async, [this] { http_.run(); })) {}
Serving::~Serving() { stop(milliseconds(0), milliseconds(0)); }
bool Serving::ends(milliseconds timeout) {
  return running_.wait_for(timeout) == std::future_status::ready;
}

Application answering(std::function<Response(const Request&)> answer) {
  Application application;
  application.answer = std::move(answer);
  application.refuse = [](const std::exception_ptr& failure, const Request& request) {
    Response response = problem_response(failure, request);
    if (!response.failure.empty()) log_failure(request.id, response.failure);
    return response;
  };
  return application;
}
Response text(std::string body) {
  return {.status = 200, .content_type = "text/plain", .body = std::move(body)};
}

Latch::Latch() : opening_(opened_.get_future()) {}
Latch::~Latch() = default;
void Latch::open() { opened_.set_value(); }
void Latch::wait() { opening_.wait(); }

// ---- Wire -----------------------------------------------------------------------------------

Wire::Wire(int port, int receive_buffer, const char* address) : witness_(port) {
  addrinfo hints{}, *found = nullptr;
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
  hints.ai_socktype = SOCK_STREAM;
  if (::getaddrinfo(address, std::to_string(port).c_str(), &hints, &found) != 0)
    throw std::runtime_error(std::string("no address ") + address);
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, ::freeaddrinfo);
  socket_ = ::socket(found->ai_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (receive_buffer > 0)
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
  if (::connect(socket_, found->ai_addr, found->ai_addrlen) != 0) {
    ::close(socket_);
    throw std::runtime_error("cannot connect to port " + std::to_string(port));
  }
}

bool Wire::send(std::string_view bytes) {
  witness_.sent(bytes);
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}
ssize_t Wire::offer(std::string_view bytes) {
  const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  if (n > 0) witness_.sent(bytes.substr(0, static_cast<std::size_t>(n)));
  return n;
}
void Wire::get(const std::string& target) {
  send("GET " + target + " HTTP/1.1\r\nHost: x\r\n\r\n");
}
void Wire::finish() { ::shutdown(socket_, SHUT_WR); }
void Wire::leave() {
  if (socket_ >= 0) ::close(socket_);
  socket_ = -1;
}

bool Wire::readable(milliseconds wait) const {
  pollfd poll{socket_, POLLIN, 0};
  return ::poll(&poll, 1, static_cast<int>(wait.count())) > 0;
}
std::string Wire::until(std::string_view mark) {
  std::string taken;
  while (!taken.ends_with(mark)) {
    const std::string more = read(1);
    if (more.empty()) break;
    taken += more;
  }
  return taken;
}
std::string Wire::rest(milliseconds timeout) {
  std::string taken;
  for (std::string more = read(1 << 16, timeout); !more.empty(); more = read(1 << 16, timeout))
    taken += more;
  return taken;
}
std::string Wire::read(std::size_t most, milliseconds timeout) {
  if (!readable(timeout)) throw std::runtime_error("neither bytes nor a close");
  std::string bytes(most, '\0');
  const ssize_t n = ::recv(socket_, bytes.data(), most, 0);
  bytes.resize(n > 0 ? static_cast<std::size_t>(n) : 0);
  witness_.received(bytes);
  return bytes;
}

int status_of(const std::string& answer) {
  const auto space = answer.find(' ');
  return space == answer.npos ? 0 : std::stoi(answer.substr(space));
}
std::string body_of(const std::string& answer) {
  const auto end = answer.find("\r\n\r\n");
  return end == answer.npos ? "" : answer.substr(end + 4);
}

}  // namespace tia::test
