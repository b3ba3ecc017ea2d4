// What there is of a picture while it is drawn, for all who want to see it.
#pragma once

#include <functional>
#include <iterator>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "server/stores/picture.h"

namespace tia::server {

/// SeenPicture: a picture on its way.
struct SeenPicture {
  std::shared_ptr<const Picture> picture;
  int round = 0;            ///< how many there have been before it
  bool is_preview = false;  ///< one ray for many pixels, or one sample
};

/// Showing: of one drawing. Any thread may call.
class Showing {
 public:
  /// Never waits, for others see the picture after it.
  using See = std::function<void(const SeenPicture&)>;

  /// Seat: who sees, until it ends.
  class Seat {
   public:
    /// Sees the newest picture that there is at once, then all others that come.
    Seat(Showing& of, See see) : of_(of), who_(of.enter(std::move(see))) {}
    ~Seat() { of_.leave(who_); }
    Seat(const Seat&) = delete;
    Seat& operator=(const Seat&) = delete;

   private:
    Showing& of_;
    const std::list<See>::iterator who_;
  };
  bool is_watched() const {
    const std::lock_guard lock(mutex_);
    return !seers_.empty();
  }
  void show(SeenPicture picture) {
    const std::lock_guard lock(mutex_);
    newest_ = std::move(picture);
    for (const See& see : seers_) see(*newest_);
  }

 private:
  std::list<See>::iterator enter(See see) {
    const std::lock_guard lock(mutex_);
    if (newest_) see(*newest_);
    seers_.push_back(std::move(see));
    return std::prev(seers_.end());
  }
  void leave(std::list<See>::iterator who) {
    const std::lock_guard lock(mutex_);
    seers_.erase(who);
  }

  mutable std::mutex mutex_;
  std::list<See> seers_;
  std::optional<SeenPicture> newest_;
};

}  // namespace tia::server
