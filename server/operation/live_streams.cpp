#include "server/operation/live_streams.h"

#include <algorithm>

#include "server/http/error.h"

namespace tia::server {

LiveStreams::Seat LiveStreams::take(const std::string& client) {
  const std::lock_guard lock(mutex_);
  if (open_ >= most_)
    throw HttpError("busy",
                    "all " + std::to_string(most_) + " live streams are open (option TIA_STREAMS)",
                    {{"Retry-After", "1"}});
  const int most_of_one = std::max(1, most_ / 4);
  Seat seat(nullptr, client);
  int& own = of_clients_[client];
  if (own >= most_of_one)
    throw HttpError("busy",
                    "one client may have " + std::to_string(most_of_one) +
                        " live streams open, a quarter of all (option TIA_STREAMS)",
                    {{"Retry-After", "1"}});
  ++own;
  ++open_;
  seat.from_ = this;
  return seat;
}

int LiveStreams::open() const {
  const std::lock_guard lock(mutex_);
  return open_;
}

void LiveStreams::leave(const std::string& client) {
  const std::lock_guard lock(mutex_);
  --open_;
  const auto own = of_clients_.find(client);
  if (--own->second == 0) of_clients_.erase(own);
}

}  // namespace tia::server
