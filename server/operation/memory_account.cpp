#include "server/operation/memory_account.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <utility>

#include "core/parallel/stopped.h"
#include "core/parallel/task_context.h"
#include "server/operation/timing.h"

namespace tia::server {
namespace {

constexpr std::int64_t growth = 1 << 20;  // by which claims grow that nobody has foreseen
// After which who waits looks again, and asks the caches. Only what a claim gives back of more than
// one step wakes all: the connections' thread, whose answers take no more, never has to.
constexpr std::chrono::milliseconds look{20};

std::string megabytes(std::int64_t bytes) { return std::to_string((bytes + (1 << 20) - 1) >> 20U); }

HttpError too_large(std::string_view what, std::int64_t bytes, std::int64_t most) {
  return {"too-large", std::string(what) + " may take " + megabytes(bytes) +
                           " MiB of memory; a request may have " + megabytes(most) +
                           " MiB (option TIA_MEMORY_BYTES)"};
}

HttpError no_memory() {
  return {"busy",
          "all memory that the server may take is in use (option TIA_MEMORY_BYTES)",
          {{"Retry-After", "1"}}};
}

// The number in a file of the control group, or none: "max" is no number.
std::int64_t number_in(const char* path, std::int64_t none) {
  std::ifstream file(path);
  std::int64_t number = none;
  return file >> number ? number : none;
}

}  // namespace

// ---- the account ----------------------------------------------------------------------------

MemoryAccount::MemoryAccount(std::int64_t limit_bytes) : limit_(limit_bytes) {
  add(program, program_bytes);
}

bool MemoryAccount::take(Holder by, std::int64_t bytes) noexcept {
  std::int64_t total = total_;
  do {
    if (total + bytes > limit_) return false;
  } while (!total_.compare_exchange_weak(total, total + bytes));
  held_[by] += bytes;
  return true;
}

void MemoryAccount::add(Holder by, std::int64_t bytes) noexcept {
  held_[by] += bytes;
  total_ += bytes;
}

void MemoryAccount::on_shortage(GiveWay give_way) { give_way_.push_back(std::move(give_way)); }

bool MemoryAccount::make_room(std::int64_t bytes) {
  for (const GiveWay& give_way : give_way_) {
    const std::int64_t missing = bytes - free();
    if (missing <= 0) return true;
    give_way(missing);
  }
  return free() >= bytes;
}

int MemoryAccount::waiting() const {
  const std::lock_guard lock(mutex_);
  return static_cast<int>(waiting_.size());
}

MemoryAccount::Client* MemoryAccount::enter(const std::string& client) {
  const std::lock_guard lock(mutex_);
  Client& known = clients_[client];
  ++known.claims;
  return &known;
}

void MemoryAccount::leave(const std::string& client) noexcept {
  const std::lock_guard lock(mutex_);
  const auto known = clients_.find(client);
  if (--known->second.claims == 0) clients_.erase(known);
}

// Whether other requests of its client have so much that this one has to wait for them.
bool MemoryAccount::has_its_share(const Waiter& who) const noexcept {
  if (who.client == nullptr || is_small(who)) return false;
  const std::int64_t others = who.client->granted - who.own;
  return others > 0 && who.client->granted + who.bytes > most_of_client();
}

bool MemoryAccount::take_more(std::int64_t own, std::int64_t bytes) noexcept {
  if (own + bytes > most_small() && free() - bytes < limit_ / 8) return false;
  return take(requests, bytes);
}

// Larger ones leave an eighth to small ones, and wait for those of them that came before.
bool MemoryAccount::take_fairly(Waiters::const_iterator who) noexcept {
  if (!is_small(*who)) {
    const auto waits_itself = [&](const Waiter& each) { return has_its_share(each); };
    const bool is_first = std::all_of(waiting_.cbegin(), who, waits_itself);
    if (!is_first || has_its_share(*who) || free() - who->bytes < limit_ / 8) return false;
  }
  if (!take(requests, who->bytes)) return false;
  if (who->client != nullptr) who->client->granted += who->bytes;
  return true;
}

bool MemoryAccount::wait_for(const Waiter& who, const std::stop_token& stop) {
  const ClaimScope nobodys(nullptr);  // a place among those that wait is the account's
  const std::int64_t bytes = who.bytes;
  std::unique_lock lock(mutex_);
  const auto place = waiting_.insert(waiting_.end(), who);
  const auto taken = [&] { return take_fairly(place); };
  bool is_taken = taken();
  if (!is_taken) ++waits_;
  const auto until = std::chrono::steady_clock::now() + most_wait;
  while (!is_taken && !stop.stop_requested() && std::chrono::steady_clock::now() < until) {
    if (!has_its_share(*place)) {
      lock.unlock();
      make_room(is_small(who) ? bytes : bytes + limit_ / 8);
      lock.lock();
    }
    is_taken = less_held_.wait_for(lock, stop, look, taken);
  }
  waiting_.erase(place);
  less_held_.notify_all();
  if (!is_taken) end_if_asked(stop);
  return is_taken;
}

// ---- shares ---------------------------------------------------------------------------------

std::size_t MemoryShare::most() const {
  if (account_ == nullptr) return static_cast<std::size_t>(most_);
  const std::int64_t left = account_->free() + booked_ - account_->limit() / 8;
  return static_cast<std::size_t>(std::clamp<std::int64_t>(left, 0, most_));
}

void MemoryShare::book(std::size_t bytes) noexcept {
  const auto now = static_cast<std::int64_t>(bytes);
  if (account_ != nullptr) account_->add(holder_, now - booked_);
  booked_ = now;
}

// ---- claims ---------------------------------------------------------------------------------

void MemoryClaim::reserve(std::int64_t bytes, std::string_view what, const std::stop_token& stop) {
  const std::int64_t wanted = std::max<std::int64_t>(used_, 0) + bytes, more = wanted - granted_;
  if (more <= 0) return;
  if (wanted > account_.most_of_one()) {
    ++account_.refusals_;
    throw too_large(what, wanted, account_.most_of_one());
  }
  enter();
  Stopwatch watch;
  const bool is_granted = account_.wait_for({more, granted_, client_}, stop);
  waited_ms_ += watch.lap_ms();
  if (!is_granted) {
    ++account_.refusals_;
    throw no_memory();
  }
  granted_ += more;  // its client's share is booked
}

MemoryClaim::~MemoryClaim() {
  grant(-granted_);
  if (client_ != nullptr) account_.leave(name_);
}

// What never reserves, as most answers of the connections' thread, waits for nobody's share.
void MemoryClaim::enter() {
  if (client_ != nullptr || name_.empty()) return;
  client_ = account_.enter(name_);
  client_->granted += granted_;
}

void MemoryClaim::grant(std::int64_t bytes) noexcept {
  granted_ += bytes;
  if (client_ != nullptr) client_->granted += bytes;
  if (bytes < 0) account_.add(MemoryAccount::requests, bytes);
  if (bytes < -growth) account_.less_held_.notify_all();
}

void MemoryClaim::settle() noexcept {
  const std::int64_t idle = granted_ - std::max<std::int64_t>(used_, 0);
  if (idle > 0) grant(-idle);
}

bool MemoryClaim::charge(std::int64_t bytes) noexcept {
  const std::int64_t used = used_ += bytes;
  const std::int64_t more = used - granted_;
  if (more > 0) {
    const std::int64_t step = std::max(more, growth);
    const bool wide = account_.take_more(granted_, step);
    if (!wide && !account_.take_more(granted_, more)) {
      used_ -= bytes;
      was_refused_ = true;
      ++account_.refusals_;
      return false;
    }
    grant(wide ? step : more);
  }
  std::int64_t most = most_used_;
  while (most < used && !most_used_.compare_exchange_weak(most, used)) continue;
  return true;
}

MemoryClaim* MemoryClaim::current() { return static_cast<MemoryClaim*>(task_context); }

HttpError MemoryClaim::refusal() const {
  if (most_used_ > account_.most_of_one() / 2)
    return too_large("this request", most_used_ + growth, account_.most_of_one());
  return no_memory();
}

ForeseenMemory::ForeseenMemory(MemoryClaim& claim, std::int64_t bytes, std::string_view what,
                               const std::stop_token& stop)
    : claim_(claim) {
  claim_.reserve(bytes, what, stop);
  if (claim_.charge(bytes)) left_ = bytes;
}

void ForeseenMemory::spend(const std::function<void()>& work) {
  const std::int64_t foreseen = std::exchange(left_, 0);
  claim_.discharge(foreseen);
  const std::int64_t before = claim_.used();
  work();
  const std::int64_t left = foreseen - std::max<std::int64_t>(0, claim_.used() - before);
  if (left > 0 && claim_.charge(left)) left_ = left;
}

ClaimScope::ClaimScope(MemoryClaim* claim) : outside_(std::exchange(task_context, claim)) {}
ClaimScope::~ClaimScope() { task_context = outside_; }

void reserve_memory(std::int64_t bytes, std::string_view what, const std::stop_token& stop) {
  if (MemoryClaim* claim = MemoryClaim::current()) claim->reserve(bytes, what, stop);
}

void settle_memory() {
  if (MemoryClaim* claim = MemoryClaim::current()) claim->settle();
}

std::int64_t usual_memory_bytes() {
  constexpr std::int64_t least = 256 << 20, unlimited = std::int64_t{1} << 60;
  std::int64_t bytes = std::int64_t{sysconf(_SC_PHYS_PAGES)} * sysconf(_SC_PAGESIZE);
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) == 0 && space.rlim_cur != RLIM_INFINITY)
    bytes = std::min(bytes, static_cast<std::int64_t>(space.rlim_cur));
  // Version 2 and version 1 of control groups, as a container sees its own.
  for (const char* path :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
    bytes = std::min(bytes, number_in(path, unlimited));
  return std::max(least, bytes / 4 * 3);
}

std::int64_t addresses_beyond(std::int64_t memory_bytes, std::int64_t later) {
  rlimit space{};
  if (getrlimit(RLIMIT_AS, &space) != 0 || space.rlim_cur == RLIM_INFINITY) return 0;
  const auto limit = static_cast<std::int64_t>(space.rlim_cur);
  const std::int64_t taken = number_in("/proc/self/statm", 0) * sysconf(_SC_PAGESIZE);
  const std::int64_t scattered = limit / 5;  // between the pieces that are in use
  return std::max<std::int64_t>(0, memory_bytes + taken + later + scattered - limit);
}

}  // namespace tia::server
