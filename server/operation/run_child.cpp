#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

#include "core/parallel/stopped.h"
#include "server/operation/child.h"
#include "server/operation/confined.h"

namespace tia::server {
namespace {

// What is still to be sent.
class Pieces {
 public:
  explicit Pieces(const std::vector<std::span<const std::uint8_t>>& pieces) : pieces_(pieces) {
    skip_empty();
  }
  bool done() const { return at_ == pieces_.size(); }
  // Sends as much as the socket takes now. Returns: whether somebody still reads.
  bool send_to(int socket) {
    const auto left = pieces_[at_].subspan(sent_);
    const ssize_t sent = send(socket, left.data(), left.size(), MSG_NOSIGNAL);
    if (sent < 0) return errno == EAGAIN || errno == EINTR;
    sent_ += static_cast<std::size_t>(sent);
    skip_empty();
    return true;
  }

 private:
  void skip_empty() {
    for (; at_ < pieces_.size() && sent_ == pieces_[at_].size(); ++at_) sent_ = 0;
  }
  const std::vector<std::span<const std::uint8_t>>& pieces_;
  std::size_t at_ = 0, sent_ = 0;
};

// Takes what has come, but no more than is needed to tell that it is too much. Domain: it is not
// yet. Returns: whether more may come.
bool receive(int socket, std::size_t most, ByteBuffer& output) {
  constexpr std::size_t piece = 1 << 16;
  const auto room = output.room(piece);
  const ssize_t got = recv(socket, room.data(), std::min(room.size(), most - output.size() + 1), 0);
  if (got < 0) return errno == EAGAIN || errno == EINTR;
  output.add(static_cast<std::size_t>(got));
  return got > 0;
}

void exchange(int socket, Pieces input, std::size_t most, const std::stop_token& stop,
              ByteBuffer& output) {
  constexpr int look_up_ms = 50;  // for a stop
  bool sending = true;
  for (;;) {
    end_if_asked(stop);
    if (sending && input.done()) {
      shutdown(socket, SHUT_WR);
      sending = false;
    }
    pollfd ready{socket, static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0};
    if (poll(&ready, 1, look_up_ms) <= 0) continue;
    if (sending && (ready.revents & POLLOUT) != 0 && !input.send_to(socket)) sending = false;
    if ((ready.revents & (POLLIN | POLLHUP | POLLERR)) != 0 && !receive(socket, most, output))
      return;
    if (output.size() > most) return;
  }
}

}  // namespace

ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   const std::vector<std::span<const std::uint8_t>>& input, std::size_t most_output,
                   const std::stop_token& stop) {
  StartedChild started = start_child(program, arguments);
  Child& child = started.child;
  ChildEnd end;
  exchange(started.socket, Pieces(input), most_output, stop, end.output);
  if (end.output.size() > most_output) child.kill();
  end.status = child.end();
  return end;
}

}  // namespace tia::server
