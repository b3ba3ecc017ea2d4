// Pictures by what they show, in bounded memory: one that has been drawn is not drawn again, and
// one that many ask for at the same time is drawn once. Any thread may call.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <unordered_map>

#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"
#include "server/operation/store_counts.h"
#include "server/stores/picture.h"
#include "server/stores/showing.h"

namespace tia::server {

/// SharedPicture: one that is being sent outlives its place in the store.
using SharedPicture = std::shared_ptr<const Picture>;

/// Where a picture came from: the store, its own drawing, or another request's that was under way.
enum class Source { stored, drawn, joined };

class PictureStore {
 public:
  /// Of 0 bytes it keeps nothing; what is asked for at the same time is drawn once all the same.
  explicit PictureStore(std::int64_t max_bytes, MemoryAccount* account = nullptr)
      : share_(max_bytes, account, MemoryAccount::pictures) {}

  struct Found {
    SharedPicture picture;
    Source source = Source::drawn;
    bool kept = false;  ///< whether it stays in the store
  };
  using Draw = std::function<Picture(const std::stop_token&)>;
  /// Wish: who wants a picture, and how it is drawn where nobody else has.
  struct Wish {
    Draw draw;
    std::stop_token stop = {};
    std::string client = {};
    /// What who waits for another's drawing holds meanwhile; may throw in its stead.
    std::function<std::shared_ptr<void>()> wait = [] { return nullptr; };
    /// Told of every other client that waits for this one's drawing.
    std::function<void(const std::string& client)> joined_by = [](const std::string&) {};
    /// Where its own drawing shows what there is by then; null: nowhere.
    std::shared_ptr<Showing> showing = nullptr;
    /// Sees what another's drawing shows; null: it does not care.
    Showing::See see = nullptr;
  };

  /// The picture of that tag, which the wish draws where nobody has; one that has a tag of its own
  /// is kept by that. It goes on as long as one of
  /// those who want it waits, whoever came first. Where a drawing is refused for want of room,
  /// which is its client's alone, who waited for it draws it. Errors: Stopped once `stop` is
  /// requested; what `draw` throws, to all who wait for it.
  Found get(const std::string& etag, const Wish& wish);
  /// The picture of that tag if it is there, at once; else none.
  std::optional<Found> find(const std::string& etag);
  /// The same, or one that another is drawing: waits for it as get() does. Errors: as get().
  std::optional<Found> find_or_join(const std::string& etag, const Wish& wish);
  /// Keeps one that is there already. Returns: whether there is room.
  bool add(const std::string& etag, const SharedPicture& picture);

  /// Keeps what a drawing was left with, by a name that is no tag, unless what is kept by it has
  /// come as far. Such rounds have half of the bytes at most.
  void keep_rounds(const std::string& name, const SharedRounds& rounds);
  /// Those of that name; or null.
  SharedRounds rounds_of(const std::string& name);

  PictureCounts counts() const;
  /// Lets go of those that nobody has asked for longest. Returns: how many bytes.
  std::int64_t give_way(std::int64_t bytes);

 private:
  struct Flight;  // a picture that is being drawn
  using SharedFlight = std::shared_ptr<Flight>;
  /// Kept: a picture, or what there is of one.
  struct Kept {
    SharedPicture picture;
    SharedRounds rounds = nullptr;
    std::size_t bytes() const;
  };
  using Pictures = LruMap<std::string, Kept>;

  Found lead(const std::string& etag, const SharedFlight& flight, const Wish& wish);
  std::optional<Found> join(const std::string& etag, const SharedFlight& flight,
                            std::unique_lock<std::mutex> lock, const Wish& wish);
  static bool wait_seated(Flight& flight, std::unique_lock<std::mutex> lock, const Wish& wish);
  void leave(const std::string& etag, Flight& flight);
  bool land(const std::string& etag, Flight& flight, const SharedPicture& picture,
            std::exception_ptr failure);
  void forget(const std::string& etag, const Flight& flight);
  SharedPicture stored(const std::string& etag);
  // Takes out what is then too much.
  bool keep(const std::string& name, const Kept& kept, Pictures::Entries& surplus);
  void take(const std::string& name, Pictures::Entries& surplus);
  void take_surplus(std::size_t most, Pictures::Entries& surplus);

  MemoryShare share_;
  mutable std::mutex mutex_;
  Pictures kept_;  // by tag, or name
  std::unordered_map<std::string, SharedFlight> flights_;
  PictureCounts counts_;
  std::size_t bytes_of_rounds_ = 0;
};

}  // namespace tia::server
