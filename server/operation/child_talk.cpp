#include "server/operation/child_talk.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include "core/parallel/stopped.h"

namespace tia::server {

ChildTalk::ChildTalk(const std::string& program, const std::vector<std::string>& arguments,
                     std::vector<Bytes> input, std::size_t most_output, std::stop_token stop)
    : started_(start_child(program, arguments)),
      input_(std::move(input)),
      left_(most_output + 1),
      stop_(std::move(stop)) {
  std::erase_if(input_, [](Bytes piece) { return piece.empty(); });
}

// Sends as much as the socket takes now, and its end after all, or once nobody reads any more.
void ChildTalk::send_more() {
  const Bytes piece = input_[at_].subspan(sent_);
  const ssize_t sent = send(started_.socket, piece.data(), piece.size(), MSG_NOSIGNAL);
  if (sent < 0) {
    sending_ = errno == EAGAIN || errno == EINTR;
    return;
  }
  sent_ += static_cast<std::size_t>(sent);
  if (sent_ < input_[at_].size()) return;
  sent_ = 0;
  ++at_;
}

std::size_t ChildTalk::read(std::span<std::uint8_t> room) {
  constexpr int look_up_ms = 50;  // for a stop
  while (!ended_ && left_ > 0) {
    end_if_asked(stop_);
    if (sending_ && at_ == input_.size()) {
      shutdown(started_.socket, SHUT_WR);
      sending_ = false;
    }
    pollfd ready{started_.socket, static_cast<short>(sending_ ? POLLIN | POLLOUT : POLLIN), 0};
    if (poll(&ready, 1, look_up_ms) <= 0) continue;
    if (sending_ && (ready.revents & POLLOUT) != 0) send_more();
    if ((ready.revents & (POLLIN | POLLHUP | POLLERR)) == 0) continue;
    const ssize_t got = recv(started_.socket, room.data(), std::min(room.size(), left_), 0);
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) continue;
    ended_ = got <= 0;
    if (ended_) break;
    left_ -= static_cast<std::size_t>(got);
    return static_cast<std::size_t>(got);
  }
  return 0;
}

int ChildTalk::end() {
  if (!ended_) started_.child.kill();
  return started_.child.end();
}

}  // namespace tia::server
