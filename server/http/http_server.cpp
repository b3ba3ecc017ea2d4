#include "server/http/http_server.h"

#include <httplib.h>

#include <algorithm>
#include <atomic>
#include <random>
#include <stdexcept>
#include <thread>

#include "core/input/errors.h"
#include "server/problem.h"

namespace tia::server {
namespace {

constexpr std::size_t connection_threads = 64;
constexpr std::size_t requests_per_connection = 100'000;
constexpr std::size_t dropped_bytes = 64 << 20;
constexpr int keep_alive_s = 5, read_timeout_s = 5, write_timeout_s = 10;

// An id fit for a log line and an answer's head: the client's, or 16 random hexadecimal digits.
std::string id_of(const std::string& asked) {
  const auto fit = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ||
           c == '_' || c == '.';
  };
  if (!asked.empty() && asked.size() <= 64 && std::all_of(asked.begin(), asked.end(), fit))
    return asked;
  thread_local std::mt19937_64 random{std::random_device{}()};
  std::string id(16, '0');
  for (char& c : id) c = "0123456789abcdef"[random() & 15U];
  return id;
}

Request plain(const httplib::Request& from) {
  Request request{from.method, from.target, {}, from.body, {}};
  for (const auto& [name, value] : from.headers) request.headers.emplace_back(name, value);
  request.id = id_of(from.get_header_value("X-Request-Id"));
  return request;
}

bool is_routed(const std::string& method) {
  constexpr std::string_view routed[] = {"GET",   "HEAD",   "POST",   "PUT",
                                         "PATCH", "DELETE", "OPTIONS"};
  return std::find(std::begin(routed), std::end(routed), method) != std::end(routed);
}

// A picture is sent whole. The library would cut ranges out of any answer, as often as they ask.
void drop_range(const httplib::Request& from) {
  const_cast<httplib::Request&>(from).ranges.clear();  // its own request, which is not const
}

void send(Response&& from, httplib::Response& to) {
  to.status = from.status;
  for (const auto& [name, value] : from.headers) to.set_header(name, value);
  if (from.unsized)  // announces a body of unknown length; HEAD sends none
    to.set_content_provider(from.content_type,
                            [](std::size_t, httplib::DataSink& sink) { return sink.done(), true; });
  else if (!from.content_type.empty()) to.set_content(std::move(from.body), from.content_type);
}

// The library closes a connection after a body whose provider fails; this one does when all has
// been written.
void send_and_close(Response&& from, httplib::Response& to) {
  const std::string body = std::move(from.body), type = std::move(from.content_type);
  from.content_type.clear();
  from.headers.emplace_back("Connection", "close");
  send(std::move(from), to);
  to.set_content_provider(body.size(), type, [body](std::size_t, std::size_t, auto& sink) {
    sink.write(body.data(), body.size());
    return false;
  });
}

}  // namespace

class HttpServer::Listener {
 public:
  Listener(HttpOptions options, Answer answer)
      : options_(std::move(options)), answer_(std::move(answer)) {
    set_up_connections();
    set_up_answers();
    port_ = options_.port != 0 && server_.bind_to_port(options_.host, options_.port) ? options_.port
            : options_.port == 0 ? server_.bind_to_any_port(options_.host)
                                 : -1;
    if (port_ < 0)
      throw std::runtime_error("cannot listen on " + options_.host + " port " +
                               std::to_string(options_.port) +
                               ": the address is in use or not this machine's");
  }

  int port() const { return port_; }
  void run() {
    started_ = true;
    if (!stopped_) server_.listen_after_bind();
    finished_ = true;
  }
  // The library forgets a stop() that comes before it listens: wait for it to, unless it never
  // will.
  void stop() {
    stopped_ = true;
    while (started_ && !finished_ && !server_.is_running()) std::this_thread::yield();
    server_.stop();
  }

 private:
  void set_up_connections() {
    server_.set_tcp_nodelay(true);  // else a keep-alive round trip waits 40 ms for an ACK
    server_.set_keep_alive_max_count(requests_per_connection);
    server_.set_keep_alive_timeout(keep_alive_s);
    server_.set_read_timeout(read_timeout_s);
    server_.set_write_timeout(write_timeout_s);
    server_.new_task_queue = [] { return new httplib::ThreadPool(connection_threads); };
    // The library would set SO_REUSEPORT, with which two servers share one port unawares.
    server_.set_socket_options([](socket_t socket) {
      const int yes = 1;
      setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
  }

  // Every method and path comes to answer_, which has the one table of routes. Bodies are read here
  // and not by the library, which would take a long `curl -d` for a form and refuse it.
  void set_up_answers() {
    static constexpr const char* any = R"([\s\S]*)";
    server_.set_pre_routing_handler([this](const httplib::Request& from, httplib::Response& to) {
      drop_range(from);
      if (is_routed(from.method)) return httplib::Server::HandlerResponse::Unhandled;
      send(answer_(plain(from)), to);
      return httplib::Server::HandlerResponse::Handled;
    });
    const auto bodiless = [this](const httplib::Request& from, httplib::Response& to) {
      send(answer_(plain(from)), to);
    };
    const auto with_body = [this](const httplib::Request& from, httplib::Response& to,
                                  const httplib::ContentReader& read) {
      // Without either there is no body (RFC 9112, 6.3), for which the library would wait in vain.
      if (!from.has_header("Content-Length") && !from.has_header("Transfer-Encoding"))
        return send(answer_(plain(from)), to);
      take_body(plain(from), from.is_multipart_form_data(), read, to);
    };
    server_.Get(any, bodiless).Options(any, bodiless);
    server_.Post(any, with_body).Put(any, with_body).Patch(any, with_body).Delete(any, with_body);
    server_.set_error_handler([this](const httplib::Request& from, httplib::Response& to) {
      if (to.status == 416) return send(answer_(plain(from)), to);  // a Range it cannot read
      if (to.status >= 400 && !to.has_header("Content-Type"))
        send(problem_response(to.status, plain(from)), to);
    });
    server_.set_exception_handler(
        [](const httplib::Request& from, httplib::Response& to, std::exception_ptr failure) {
          send(problem_response(failure, plain(from)), to);
        });
  }

  // What is beyond the limit is read and dropped, as far as that is cheap: to close on a client
  // that still writes would reset the connection and lose the answer.
  void take_body(Request request, bool multipart, const httplib::ContentReader& read,
                 httplib::Response& to) {
    const auto most = static_cast<std::size_t>(options_.max_body_bytes);
    std::size_t come = 0;
    const auto take = [&](const char* data, std::size_t size) {
      come += size;
      if (come <= most) request.body.append(data, size);
      return come <= most + dropped_bytes;
    };
    const auto any_part = [](const httplib::MultipartFormData&) { return true; };
    const bool whole = multipart ? read(any_part, take) : read(take);
    const auto refusal = [&](const HttpError& error) {
      return problem_response(std::make_exception_ptr(error), request);
    };
    if (come > most)
      send_and_close(refusal({"too-large", "a body may have " + std::to_string(most) +
                                               " bytes (option TIA_MAX_BODY_BYTES)"}),
                     to);
    else if (whole) send(answer_(request), to);
    else if (multipart) send_and_close(answer_(request), to);
    else
      send_and_close(refusal({"malformed", "the body broke off or is not framed as declared"}), to);
  }

  HttpOptions options_;
  Answer answer_;
  httplib::Server server_;
  int port_ = -1;
  std::atomic<bool> started_ = false, stopped_ = false, finished_ = false;
};

HttpServer::HttpServer(HttpOptions options, Answer answer)
    : listener_(std::make_unique<Listener>(std::move(options), std::move(answer))) {}
HttpServer::~HttpServer() = default;
int HttpServer::port() const { return listener_->port(); }
void HttpServer::run() { listener_->run(); }
void HttpServer::stop() { listener_->stop(); }

bool answers(const std::string& host, int port, const std::string& path) {
  httplib::Client client(host, port);
  client.set_connection_timeout(2);
  client.set_read_timeout(2);
  const auto response = client.Get(path);
  return response && response->status == 200;
}

}  // namespace tia::server
