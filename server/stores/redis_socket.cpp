#include "server/stores/redis_socket.h"

#include <array>
#include <asio/connect.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/post.hpp>
#include <asio/ssl.hpp>
#include <asio/write.hpp>
#include <atomic>
#include <optional>
#include <stdexcept>

namespace tia::server {
namespace {

constexpr std::size_t portion_bytes = 64 << 10;

}  // namespace

struct RedisSocket::Stream {
  asio::io_context io{1};
  asio::ip::tcp::resolver resolver{io};
  asio::ip::tcp::socket plain{io};
  // Only with TLS, for OpenSSL takes a megabyte once it is begun.
  std::optional<asio::ssl::context> tls = {};
  std::optional<asio::ssl::stream<asio::ip::tcp::socket&>> secure = {};
  std::atomic<bool> is_interrupted = false;
  std::array<char, portion_bytes> portion{};

  // Begins what `begin` does and waits for its end; what is not done by then is broken off.
  // Returns: whether it is done.
  template <class Begin>
  bool done_by(Deadline until, const char* what, const Begin& begin) {
    std::optional<asio::error_code> ended;
    begin([&](const asio::error_code& error, auto&&...) { ended = error; });
    io.restart();
    while (!ended && !is_interrupted && io.run_one_until(until) > 0) {
    }
    const bool is_done = ended.has_value();
    if (!is_done) {
      asio::error_code ignored;
      resolver.cancel();
      plain.cancel(ignored);
      io.restart();
      while (!ended && io.run_one() > 0) {
      }
    }
    if (is_interrupted) throw std::runtime_error(std::string(what) + ": interrupted");
    if (is_done && *ended) throw std::runtime_error(std::string(what) + ": " + ended->message());
    return is_done;
  }
  template <class Begin>
  void require_by(Deadline until, const char* what, const Begin& begin) {
    if (!done_by(until, what, begin)) throw std::runtime_error(std::string(what) + ": timed out");
  }

  void shake_hands(const std::string& host, const std::string& ca_file, Deadline until) {
    tls.emplace(asio::ssl::context::tls_client);
    if (ca_file.empty()) tls->set_default_verify_paths();
    else tls->load_verify_file(ca_file);
    secure.emplace(plain, *tls);
    secure->set_verify_mode(asio::ssl::verify_peer);
    secure->set_verify_callback(asio::ssl::host_name_verification(host));
    SSL_set_tlsext_host_name(secure->native_handle(), host.c_str());
    require_by(until, "TLS", [&](auto end) {
      secure->async_handshake(asio::ssl::stream_base::client, std::move(end));
    });
  }
};

RedisSocket::RedisSocket(const std::string& host, int port, bool is_tls, const std::string& ca_file,
                         Deadline until)
    : stream_(std::make_unique<Stream>()) {
  asio::ip::tcp::resolver::results_type found;
  stream_->require_by(until, host.c_str(), [&](auto end) {
    stream_->resolver.async_resolve(host, std::to_string(port),
                                    [&found, end](const asio::error_code& error, auto results) {
                                      found = std::move(results);
                                      end(error);
                                    });
  });
  stream_->require_by(until, host.c_str(), [&](auto end) {
    asio::async_connect(stream_->plain, found, std::move(end));
  });
  stream_->plain.set_option(asio::ip::tcp::no_delay(true));
  stream_->plain.set_option(asio::socket_base::keep_alive(true));
  if (is_tls) stream_->shake_hands(host, ca_file, until);
}
RedisSocket::~RedisSocket() = default;

void RedisSocket::write(std::string_view bytes, Deadline until) {
  const asio::const_buffer all(bytes.data(), bytes.size());
  stream_->require_by(until, "write", [&](auto end) {
    if (stream_->secure) asio::async_write(*stream_->secure, all, std::move(end));
    else asio::async_write(stream_->plain, all, std::move(end));
  });
}

std::string_view RedisSocket::read(Deadline until) {
  std::size_t came = 0;
  const asio::mutable_buffer to = asio::buffer(stream_->portion);
  stream_->done_by(until, "read", [&](auto end) {
    const auto count = [&came, end](const asio::error_code& error, std::size_t bytes) {
      came = bytes;
      end(error);
    };
    if (stream_->secure) stream_->secure->async_read_some(to, count);
    else stream_->plain.async_read_some(to, count);
  });
  return {stream_->portion.data(), came};
}

void RedisSocket::interrupt() {
  stream_->is_interrupted = true;
  asio::post(stream_->io, [] {});  // wakes who waits
}

}  // namespace tia::server
