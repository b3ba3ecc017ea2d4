#include "server/http/acceptors.h"

#include <asio/ip/v6_only.hpp>
#include <stdexcept>
#include <utility>

namespace tia::server {
namespace {

using asio::ip::tcp;

constexpr std::size_t backlog = 4096;  // connections that wait to be accepted
constexpr std::chrono::milliseconds breath{50};

// Whether the system cannot give a connection of those that we have more than enough of.
bool is_shortage(const asio::error_code& error) {
  return error == asio::error::no_descriptors || error == asio::error::no_buffer_space ||
         error == asio::error::no_memory || error == std::errc::too_many_files_open_in_system;
}

}  // namespace

Acceptors::Acceptors(asio::io_context& io, const std::string& host, int port, Welcome welcome,
                     std::function<void()> make_room)
    : io_(io), welcome_(std::move(welcome)), make_room_(std::move(make_room)), port_(port) {
  const char* hint = "";
  try {
    tcp::resolver resolver(io);
    const auto found = resolver.resolve(host, std::to_string(port),
                                        tcp::resolver::passive | tcp::resolver::numeric_service);
    hint = " (the address is in use or not this machine's)";
    for (const auto& entry : found)
      open({entry.endpoint().address(), static_cast<unsigned short>(port_)});
  } catch (const std::system_error& error) {
    throw std::runtime_error("cannot listen on " + host + " port " + std::to_string(port_) + ": " +
                             error.code().message() + hint);
  }
}

void Acceptors::open(const tcp::endpoint& endpoint) {
  tcp::acceptor& acceptor = acceptors_.emplace_back(io_).socket;
  acceptor.open(endpoint.protocol());
  // Not SO_REUSEPORT, with which two servers share one port unawares.
  acceptor.set_option(tcp::acceptor::reuse_address(true));
  if (endpoint.address().is_v6())  // of :: alone, IPv4 is a part
    acceptor.set_option(asio::ip::v6_only(!endpoint.address().is_unspecified()));
  acceptor.bind(endpoint);
  acceptor.listen(static_cast<int>(backlog));
  acceptor.non_blocking(true);
  // Else the library waits for the next client to come, where another may have come already.
  acceptor.set_option(tcp::acceptor::enable_connection_aborted(true));
  port_ = acceptor.local_endpoint().port();
}

void Acceptors::accept_all() {
  for (Acceptor& acceptor : acceptors_) {
    if (!acceptor.socket.is_open()) continue;
    asio::error_code error;
    acceptor.socket.cancel(error);
    accept(acceptor);
  }
}

void Acceptors::accept(Acceptor& acceptor) {
  const int call = ++acceptor.calls;
  acceptor.socket.async_accept([this, &acceptor, call](asio::error_code error, tcp::socket socket) {
    if (error == asio::error::operation_aborted || !acceptor.socket.is_open()) return;
    if (!error) welcome_(std::move(socket));
    if (call != acceptor.calls) return;  // a later one waits
    if (!error) return accept(acceptor);
    // That there are no descriptors left the system says even if nobody has come.
    const bool needs_room = is_shortage(error);
    acceptor.socket.wait(tcp::acceptor::wait_read, error);
    if (needs_room && !error) make_room_();
    acceptor.resting.expires_after(breath);
    acceptor.resting.async_wait([this, &acceptor](asio::error_code interrupted) {
      if (!interrupted) accept(acceptor);
    });
  });
}

std::vector<tcp::socket> Acceptors::close() {
  std::vector<tcp::socket> last;
  for (Acceptor& acceptor : acceptors_) {
    asio::error_code error;
    while (!error && last.size() < backlog) last.push_back(acceptor.socket.accept(error));
    if (error && !last.empty()) last.pop_back();
    acceptor.socket.close(error);
    acceptor.resting.cancel();
  }
  return last;
}

}  // namespace tia::server
