// Who asks, what they may do, and how much: keys, signed URLs, quotas.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/access/caller.h"
#include "server/access/key_ring.h"
#include "server/access/quotas.h"
#include "server/http/error.h"
#include "server/http/message.h"

namespace tia::server {

class Metrics;

/// AccessRefusal: what is answered to who may not, and why, as metrics count it.
class AccessRefusal : public HttpError {
 public:
  AccessRefusal(std::string_view type, std::string_view why, std::string detail,
                Headers headers = {})
      : HttpError(type, std::move(detail), std::move(headers)), why_(why) {}
  std::string_view why() const { return why_; }

 private:
  std::string_view why_;
};

/// The time: ns since 1970.
std::int64_t system_time();

/// Access: any thread may call.
class Access {
 public:
  using Now = std::function<std::int64_t()>;

  /// Errors: as KeyRing.
  Access(const Config& config, Metrics& metrics, Now now = system_time,
         std::unique_ptr<Quotas> quotas = std::make_unique<OwnQuotas>());

  /// Reads the files anew. Errors: as KeyRing; then all stays as it was.
  void reload();

  /// Notes in the request who it says it is from, and whether that holds; a signature is taken off
  /// its target. First of all: what is told of a request later has no secret in it.
  void identify(Request& request) const;

  /// Errors: AccessRefusal: unauthorized where a key is needed, or what the request says does not
  /// hold; forbidden where the key lacks a right; quota where it has asked too often. Otherwise it
  /// is one request of the key's. What needs no right is anybody's, and not counted.
  void admit(const Request& request, const std::vector<Right>& needs);
  /// The same where it may be refused elsewhere, and waits for nobody. Returns: whether it may.
  bool takes(const Request& request, const std::vector<Right>& needs);

  /// Errors: AccessRefusal (forbidden) for what is another key's, unless the caller's has the right
  /// admin; `owner`: the id of a key, "" = nobody's, which is for all who know of it.
  void check_owner(const Request& request, const std::string& owner);

  /// Says in the answer who may keep it, and what is left of quotas.
  void tell(Response& response, const Request& request);

  /// What holds for the key of that id, "" for whoever has none; null where nothing limits it.
  std::shared_ptr<const KeyEntry> entry_called(const std::string& key) const;

  /// Errors: AccessRefusal (quota) where so many rays are more than the key has left today; "" is
  /// whoever has none.
  void check_rays(const std::string& key, double rays);
  /// Counts rays that have been traced.
  void charge(const std::string& key, std::int64_t rays);

 private:
  std::shared_ptr<const KeyRing> ring() const;
  std::shared_ptr<const KeyEntry> entry_for(const Request& request) const;
  void check_rights(const Request& request, const std::vector<Right>& needs) const;
  std::optional<RequestsLeft> requests_left(const KeyEntry& entry, bool take);
  std::int64_t day() const;
  std::int64_t seconds_to_midnight() const;

  const Config& config_;
  Metrics& metrics_;
  const Now now_;
  const std::unique_ptr<Quotas> quotas_;
  mutable std::mutex mutex_;
  std::shared_ptr<const KeyRing> ring_;
};

}  // namespace tia::server
