#include "server/stores/picture_store.h"

#include <new>
#include <utility>

#include "server/http/error.h"

namespace tia::server {
namespace {

constexpr std::size_t picture_entry_bytes = 512;  // an entry's own, with its places in the tables

std::size_t bytes_of(const Picture& picture) {
  return picture_entry_bytes + picture.bytes.capacity();
}

bool is_busy(const std::exception_ptr& failure) {
  if (!failure) return false;
  try {
    std::rethrow_exception(failure);
  } catch (const HttpError& error) {
    return error.type() == "busy";
  } catch (...) {
    return false;
  }
}

}  // namespace

/// Flight: one thread draws, others may wait. All but `stop` is guarded by the store's mutex.
struct PictureStore::Flight {
  explicit Flight(const Wish& wish) : joined_by(wish.joined_by), showing(wish.showing) {}

  std::stop_source stop;
  const std::function<void(const std::string&)> joined_by;
  const std::shared_ptr<Showing> showing;  // null: nothing is shown
  int waiting = 1;                         // who still wants it
  bool landed = false, kept = false;
  SharedPicture picture;
  std::exception_ptr failure;
  std::condition_variable_any has_landed;
};

PictureStore::Found PictureStore::get(const std::string& etag, const Wish& wish) {
  for (;;) {
    std::unique_lock lock(mutex_);
    if (const SharedPicture* stored = pictures_.find(etag)) {
      ++counts_.stored;
      return {*stored, Source::stored, true};
    }
    const auto known = flights_.find(etag);
    if (known == flights_.end()) {
      const auto flight = std::make_shared<Flight>(wish);
      flights_.emplace(etag, flight);
      ++counts_.drawn;
      lock.unlock();
      return lead(etag, flight, wish);
    }
    const std::shared_ptr<void> place = wish.wait();
    if (auto found = join(etag, known->second, std::move(lock), wish)) return *found;
  }
}

std::optional<PictureStore::Found> PictureStore::find_or_join(const std::string& etag,
                                                              const Wish& wish) {
  std::unique_lock lock(mutex_);
  if (const SharedPicture* stored = pictures_.find(etag)) {
    ++counts_.stored;
    return Found{*stored, Source::stored, true};
  }
  const auto known = flights_.find(etag);
  if (known == flights_.end()) return std::nullopt;
  const std::shared_ptr<void> place = wish.wait();
  return join(etag, known->second, std::move(lock), wish);
}

bool PictureStore::add(const std::string& etag, const SharedPicture& picture) {
  Pictures::Entries surplus;
  const std::lock_guard lock(mutex_);
  return pictures_.contains(etag) || keep(etag, picture, surplus);
}

std::optional<PictureStore::Found> PictureStore::find(const std::string& etag) {
  const std::lock_guard lock(mutex_);
  const SharedPicture* stored = pictures_.find(etag);
  if (stored == nullptr) return std::nullopt;
  ++counts_.stored;
  return Found{*stored, Source::stored, true};
}

PictureStore::Found PictureStore::lead(const std::string& etag, const SharedFlight& flight,
                                       const Wish& wish) {
  const std::stop_callback left(wish.stop, [&] { leave(etag, *flight); });
  SharedPicture picture;
  std::exception_ptr failure;
  try {
    picture = std::make_shared<const Picture>(wish.draw(flight->stop.get_token()));
  } catch (...) {
    failure = std::current_exception();
  }
  const bool kept = land(etag, *flight, picture, failure);
  if (failure) std::rethrow_exception(failure);
  return {picture, Source::drawn, kept};
}

// Returns: none where it was refused for want of room.
std::optional<PictureStore::Found> PictureStore::join(const std::string& etag,
                                                      const SharedFlight& flight,
                                                      std::unique_lock<std::mutex> lock,
                                                      const Wish& wish) {
  const SharedFlight mine = flight;
  mine->joined_by(wish.client);
  std::optional<Showing::Seat> seat;
  if (mine->showing && wish.see) seat.emplace(*mine->showing, wish.see);
  ++mine->waiting;
  ++counts_.joined;
  if (!mine->has_landed.wait(lock, wish.stop, [&] { return mine->landed; })) {
    lock.unlock();
    leave(etag, *mine);
    throw Stopped();
  }
  if (is_busy(mine->failure)) return std::nullopt;
  if (mine->failure) std::rethrow_exception(mine->failure);
  return Found{mine->picture, Source::joined, mine->kept};
}

// One who comes after the last has left begins anew: what nobody waited for is being given up.
void PictureStore::leave(const std::string& etag, Flight& flight) {
  std::unique_lock lock(mutex_);
  if (flight.landed || --flight.waiting > 0) return;
  forget(etag, flight);
  lock.unlock();
  flight.stop.request_stop();
}

void PictureStore::forget(const std::string& etag, const Flight& flight) {
  const auto known = flights_.find(etag);
  if (known != flights_.end() && known->second.get() == &flight) flights_.erase(known);
}

// Hands the picture, or what failed, to all who wait. Returns: whether the picture is kept, too.
bool PictureStore::land(const std::string& etag, Flight& flight, const SharedPicture& picture,
                        std::exception_ptr failure) {
  Pictures::Entries surplus;
  const std::lock_guard lock(mutex_);
  forget(etag, flight);
  flight.landed = true;
  flight.picture = picture;
  flight.failure = std::move(failure);
  flight.has_landed.notify_all();
  if (!picture) return false;
  try {
    const std::string& name = picture->etag.empty() ? etag : picture->etag;
    if (!pictures_.contains(name)) flight.kept = keep(name, picture, surplus);
  } catch (const std::bad_alloc&) {  // then it is sent all the same
  }
  return flight.kept;
}

bool PictureStore::keep(const std::string& etag, const SharedPicture& picture,
                        Pictures::Entries& surplus) {
  const std::size_t bytes = bytes_of(*picture), most = share_.most();
  if (bytes > most) return false;
  pictures_.add(etag, picture);
  counts_.bytes += bytes;
  take_surplus(most, surplus);
  share_.book(counts_.bytes);
  return true;
}

void PictureStore::take_surplus(std::size_t most, Pictures::Entries& surplus) {
  while (counts_.bytes > most) {
    counts_.bytes -= bytes_of(*pictures_.last());
    pictures_.take_last(surplus);
  }
}

std::int64_t PictureStore::give_way(std::int64_t bytes) {
  Pictures::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t before = counts_.bytes, less = static_cast<std::size_t>(bytes);
  take_surplus(before > less ? before - less : 0, surplus);
  share_.book(counts_.bytes);
  return static_cast<std::int64_t>(before - counts_.bytes);
}

PictureCounts PictureStore::counts() const {
  const std::lock_guard lock(mutex_);
  PictureCounts counts = counts_;
  counts.pictures = pictures_.size();
  return counts;
}

}  // namespace tia::server
