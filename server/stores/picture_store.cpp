#include "server/stores/picture_store.h"

#include <new>
#include <utility>

#include "core/render/kept_rounds.h"
#include "server/http/error.h"

namespace tia::server {
namespace {

constexpr std::size_t picture_entry_bytes = 512;  // an entry's own, with its places in the tables

// Of the client alone who asked, so that who waited for it may draw it.
bool is_busy(const std::exception_ptr& failure) {
  if (!failure) return false;
  try {
    std::rethrow_exception(failure);
  } catch (const HttpError& error) {
    return error.type() == "busy" || error.type() == "quota";
  } catch (...) {
    return false;
  }
}

}  // namespace

std::size_t PictureStore::Kept::bytes() const {
  return picture_entry_bytes + (rounds ? rounds->bytes() : picture->bytes.capacity());
}

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
    if (const SharedPicture kept = stored(etag)) return {kept, Source::stored, true};
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
  if (const SharedPicture kept = stored(etag)) return Found{kept, Source::stored, true};
  const auto known = flights_.find(etag);
  if (known == flights_.end()) return std::nullopt;
  const std::shared_ptr<void> place = wish.wait();
  return join(etag, known->second, std::move(lock), wish);
}

bool PictureStore::add(const std::string& etag, const SharedPicture& picture) {
  Pictures::Entries surplus;
  const std::lock_guard lock(mutex_);
  return kept_.contains(etag) || keep(etag, {picture}, surplus);
}

void PictureStore::keep_rounds(const std::string& name, const SharedRounds& rounds) {
  Pictures::Entries surplus;
  const std::lock_guard lock(mutex_);
  const Kept* const known = kept_.find(name);
  if (known != nullptr && known->rounds->samples() >= rounds->samples()) return;
  const Kept kept{nullptr, rounds};
  const std::size_t most = share_.most() / 2;
  if (kept.bytes() > most) return;
  if (known != nullptr) take(name, surplus);
  while (bytes_of_rounds_ + kept.bytes() > most)
    take(*kept_.last_of([](const Kept& each) { return each.rounds != nullptr; }), surplus);
  keep(name, kept, surplus);
}

SharedRounds PictureStore::rounds_of(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const Kept* const known = kept_.find(name);
  return known != nullptr ? known->rounds : nullptr;
}

std::optional<PictureStore::Found> PictureStore::find(const std::string& etag) {
  const std::lock_guard lock(mutex_);
  const SharedPicture kept = stored(etag);
  if (!kept) return std::nullopt;
  return Found{kept, Source::stored, true};
}

SharedPicture PictureStore::stored(const std::string& etag) {
  const Kept* const known = kept_.find(etag);
  if (known == nullptr) return nullptr;
  ++counts_.stored;
  return known->picture;
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
  ++mine->waiting;
  ++counts_.joined;
  if (!wait_seated(*mine, std::move(lock), wish)) {
    leave(etag, *mine);
    throw Stopped();
  }
  if (is_busy(mine->failure)) return std::nullopt;
  if (mine->failure) std::rethrow_exception(mine->failure);
  return Found{mine->picture, Source::joined, mine->kept};
}

// Who sees what is shown sits down and gets up without the store's lock: others' pictures do not
// wait for it. What has landed does not change any more.
bool PictureStore::wait_seated(Flight& flight, std::unique_lock<std::mutex> lock,
                               const Wish& wish) {
  lock.unlock();
  std::optional<Showing::Seat> seat;
  try {
    if (flight.showing && wish.see) seat.emplace(*flight.showing, wish.see);
  } catch (const std::bad_alloc&) {  // then it sees the end only
  }
  lock.lock();
  const bool landed = flight.has_landed.wait(lock, wish.stop, [&] { return flight.landed; });
  lock.unlock();
  return landed;
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
    if (!kept_.contains(name)) flight.kept = keep(name, {picture}, surplus);
  } catch (const std::bad_alloc&) {  // then it is sent all the same
  }
  return flight.kept;
}

bool PictureStore::keep(const std::string& name, const Kept& kept, Pictures::Entries& surplus) {
  const std::size_t bytes = kept.bytes(), most = share_.most();
  if (bytes > most) return false;
  kept_.add(name, kept);
  counts_.bytes += bytes;
  if (kept.rounds) bytes_of_rounds_ += bytes, ++counts_.rounds;
  take_surplus(most, surplus);
  share_.book(counts_.bytes);
  return true;
}

void PictureStore::take(const std::string& name, Pictures::Entries& surplus) {
  kept_.take(name, surplus);
  const Kept& taken = surplus.back().value;
  counts_.bytes -= taken.bytes();
  if (taken.rounds) bytes_of_rounds_ -= taken.bytes(), --counts_.rounds;
}

void PictureStore::take_surplus(std::size_t most, Pictures::Entries& surplus) {
  while (counts_.bytes > most) take(kept_.last_key(), surplus);
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
  counts.pictures = kept_.size() - counts.rounds;
  return counts;
}

}  // namespace tia::server
