#include "server/http/answer_writer.h"

#include <httplib.h>

#include <cstdio>
#include <ctime>
#include <exception>
#include <utility>

#include "core/parallel/per_thread.h"
#include "core/parallel/stopped.h"
#include "server/http/timeouts.h"

namespace tia::server {
namespace {

// What the library takes for a connection: the shortest request, and a place for the answer.
class Memory : public httplib::Stream {
 public:
  Memory(std::string_view request, const TakeBytes& take) : request_(request), take_(take) {}
  bool is_readable() const override { return !request_.empty(); }
  bool is_writable() const override { return true; }
  ssize_t read(char* to, std::size_t size) override {
    const std::size_t n = request_.copy(to, size);
    request_.remove_prefix(n);
    return static_cast<ssize_t>(n);
  }
  ssize_t write(const char* from, std::size_t size) override {
    return take_({from, size}, Part::next) ? static_cast<ssize_t>(size) : -1;
  }
  void get_remote_ip_and_port(std::string&, int&) const override {}
  void get_local_ip_and_port(std::string&, int&) const override {}
  socket_t socket() const override { return 0; }

 private:
  std::string_view request_;
  const TakeBytes& take_;
};

// RFC 9110, 5.6.7. Made once a second.
const char* http_date() {
  thread_local std::time_t of = 0;
  thread_local char date[40];
  const std::time_t now = std::time(nullptr);
  if (std::exchange(of, now) == now) return date;
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::strftime(date, sizeof date, "%a, %d %b %Y %H:%M:%S GMT", &utc);
  return date;
}

// Writer: the library's server, with every request answered by what is to be sent.
class Writer : httplib::Server {
 public:
  Writer() {
    svr_sock_ = 0;  // else the library takes itself for stopped and sends no part
    set_keep_alive_timeout(timeouts::idle.count());  // which the answers' heads tell
    set_keep_alive_max_count(timeouts::most_requests);
    set_pre_routing_handler([this](const httplib::Request&, httplib::Response& to) {
      fill(to);
      return HandlerResponse::Handled;
    });
    set_exception_handler([this](const auto&, auto&, std::exception_ptr thrown) {
      failure_ = std::move(thrown);  // else the library makes an answer of its own of it
    });
  }
  void write(Response& response, bool is_head, bool keep_alive, const TakeBytes& take) {
    from_ = &response;
    take_ = &take;
    failure_ = nullptr;
    const TakeBytes take_more = [&](std::string_view bytes, Part part) {
      return !failure_ && take(bytes, part);
    };
    Memory memory(is_head ? "HEAD / HTTP/1.1\r\n\r\n" : "GET / HTTP/1.1\r\n\r\n", take_more);
    bool closed = false;
    process_request(memory, !keep_alive, closed, nullptr);
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void fill(httplib::Response& to) {
    Response& from = *from_;
    to.status = from.status;
    to.set_header("Date", http_date());
    to.set_header("Accept-Ranges", "none");  // else the library promises bytes
    for (const auto& [name, value] : from.headers) to.set_header(name, value);
    if (from.parts) fill_parts(to);
    else if (from.shared) announce(to, from.shared->size());
    else if (from.unsized)  // announces a body of unknown length; HEAD sends none
      to.set_content_provider(from.content_type, [](std::size_t, httplib::DataSink& sink) {
        sink.done();
        return true;
      });
    else if (!from.content_type.empty()) {
      to.body.swap(from.body);
      to.set_header("Content-Type", from.content_type);
    }
  }

  // The head of an answer whose body is sent by itself.
  void announce(httplib::Response& to, std::size_t bytes) const {
    to.set_content_provider(bytes, from_->content_type,
                            [](std::size_t, std::size_t, httplib::DataSink&) { return false; });
  }

  // Parts go past the library, whose sink knows one thread only and no parts that are replaced.
  void fill_parts(httplib::Response& to) {
    to.set_chunked_content_provider(
        from_->content_type, [this](std::size_t, httplib::DataSink& sink) {
          try {
            from_->parts({[&](std::string_view part) {
                            if (part.empty()) return;  // which would end it
                            if (!(*take_)(chunk_of(part), Part::next)) throw Stopped();
                          },
                          [&](std::string_view part) { (*take_)(chunk_of(part), Part::latest); },
                          [&] {
                            if (!(*take_)({}, Part::taken)) throw Stopped();
                          }});
            sink.done();
            return true;
          } catch (...) {
            failure_ = std::current_exception();
            return false;
          }
        });
  }

  Response* from_ = nullptr;
  const TakeBytes* take_ = nullptr;
  std::exception_ptr failure_;  // of what makes the answer, or its parts
};

// The library says that there are 0 bytes, which would be the length of what a 304 spares, and has
// no place in a 204. Source: RFC 9110, 8.6.
void drop_length(std::string& bytes) {
  constexpr std::string_view length = "Content-Length: 0\r\n";
  if (const auto at = bytes.find(length); at != bytes.npos) bytes.erase(at, length.size());
}

}  // namespace

void write_answer(Response& response, bool is_head, bool keep_alive, const TakeBytes& take) {
  const bool head_only = is_head || response.shared != nullptr;
  per_thread<Writer, struct OfAllAnswers>().write(response, head_only, keep_alive, take);
}

std::string chunk_of(std::string_view part) {
  char size[20];
  const int digits = std::snprintf(size, sizeof size, "%zx\r\n", part.size());
  std::string chunk;
  chunk.reserve(part.size() + sizeof size);
  return chunk.append(size, static_cast<std::size_t>(digits)).append(part).append("\r\n");
}

std::string answer_bytes(Response& response, bool is_head, bool keep_alive) {
  std::string bytes;
  bytes.reserve(response.body.size() + 1024);
  write_answer(response, is_head, keep_alive, [&](std::string_view part, Part) {
    bytes.append(part);
    return true;
  });
  if (response.status == 304 || response.status == 204) drop_length(bytes);
  return bytes;
}

}  // namespace tia::server
