// How many live streams may be open: pictures that come while their client looks on.
#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

namespace tia::server {

/// LiveStreams: places for live streams, each of which keeps a worker, and hardly any of its time,
/// for as long as somebody looks on. One client has at most a quarter of them. Any thread may call.
class LiveStreams {
 public:
  explicit LiveStreams(int most) : most_(most) {}

  /// Seat: a place, until its end.
  class Seat {
   public:
    Seat(Seat&& from) noexcept
        : from_(std::exchange(from.from_, nullptr)), client_(std::move(from.client_)) {}
    ~Seat() {
      if (from_ != nullptr) from_->leave(client_);
    }

   private:
    friend LiveStreams;
    Seat(LiveStreams* from, std::string client) : from_(from), client_(std::move(client)) {}
    LiveStreams* from_;
    std::string client_;
  };

  /// Errors: HttpError (busy) where all places, or all that one client may have, are taken.
  [[nodiscard]] Seat take(const std::string& client);
  int open() const;

 private:
  void leave(const std::string& client);

  const int most_;
  mutable std::mutex mutex_;
  std::map<std::string, int> of_clients_;
  int open_ = 0;
};

}  // namespace tia::server
