// The half of a connection that has to do with bodies that come by and by.
#include <asio/post.hpp>

#include "server/http/answer_writer.h"
#include "server/http/connection.h"
#include "server/http/timeouts.h"

namespace tia::server {
namespace {

// What the system may hold for a client that does not read, so that this is noticed.
constexpr int fed_buffer_bytes = 16 << 10;

void set_send_buffer(asio::ip::tcp::socket& socket, int bytes) {
  asio::error_code error;
  socket.set_option(asio::ip::tcp::socket::send_buffer_size(bytes), error);
}

}  // namespace

void Connection::begin_feed(std::shared_ptr<Feed> feed, bool is_chunked) {
  is_chunked_ = is_chunked;
  feed_ = std::move(feed);
  set_send_buffer(socket_, fed_buffer_bytes);
  enter(Phase::feeding, timeouts::look);
  gone_ = 0;
  gone_at_ = since_;
  if (context_.closing) return retire();
  feed_->listen([weak = weak_from_this(), &context = context_] {
    context.tell([weak] {
      if (const auto self = weak.lock(); self && self->phase_ == Phase::feeding) self->proceed();
    });
  });
}

// Returns: false where nothing has come.
bool Connection::take_fed() {
  const Feed::Piece piece = feed_->take();
  if (piece.bytes.empty() && !piece.is_last) return false;
  std::string bytes = is_chunked_ && !piece.bytes.empty() ? chunk_of(piece.bytes) : piece.bytes;
  if (!piece.is_last) {
    outbox_.put(std::move(bytes));
    account();
    return true;
  }
  if (is_chunked_) bytes += last_chunk;
  end_feed(std::move(bytes));
  return true;
}

void Connection::end_feed(std::string last) {
  drop_feed();
  set_send_buffer(socket_, static_cast<int>(timeouts::most_at_once));
  outbox_.put(std::move(last));
  account();
  enter(Phase::writing, timeouts::look);
  gone_at_ = since_;
}

// Who lets what has come lie for so long is not there: it may come again, and go on.
void Connection::watch_feed(Clock::time_point now) {
  const std::size_t waiting = waiting_bytes();
  const std::size_t gone = outbox_.sent() - waiting;
  if ((outbox_.empty() && waiting == 0) || gone != gone_) gone_at_ = now;
  gone_ = gone;
  if (now - gone_at_ >= timeouts::answer) return close();
  due_ = now + timeouts::look;
}

void Connection::drop_feed() {
  if (feed_) feed_->listen(nullptr);
  feed_.reset();
}

}  // namespace tia::server
