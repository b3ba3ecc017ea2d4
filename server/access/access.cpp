#include "server/access/access.h"

#include <algorithm>
#include <chrono>

#include "server/operation/config.h"
#include "server/operation/metrics.h"

namespace tia::server {
namespace {

constexpr std::int64_t one_second = 1'000'000'000, day_s = 86'400;

std::int64_t seconds_up(std::int64_t ns) { return (ns + one_second - 1) / one_second; }

[[noreturn]] void refuse_unauthorized(std::string_view why, const std::string& detail) {
  const bool has_token = why != "none";
  throw AccessRefusal("unauthorized", why, detail,
                      {{"WWW-Authenticate", std::string("Bearer realm=\"tia\"") +
                                                (has_token ? ", error=\"invalid_token\"" : "")}});
}

[[noreturn]] void refuse_quota(std::string_view why, const std::string& detail,
                               std::int64_t seconds) {
  throw AccessRefusal("quota", why, detail,
                      {{"Retry-After", std::to_string(std::max<std::int64_t>(1, seconds))}});
}

// A key's rate, where it has one.
std::optional<RequestRate> rate_of(const KeyEntry& entry) {
  if (!entry.requests_per_s) return std::nullopt;
  const auto usual = static_cast<int>(std::max(1.0, *entry.requests_per_s));
  return RequestRate::of(*entry.requests_per_s, entry.burst.value_or(usual));
}

std::int64_t rays_left(const KeyEntry& entry, std::int64_t rays) {
  return std::max<std::int64_t>(0, *entry.rays_per_day - rays);
}

std::string* field_of(Response& response, std::string_view name) {
  const auto found = std::ranges::find(response.headers, name, &Headers::value_type::first);
  return found == response.headers.end() ? nullptr : &found->second;
}

// A key's answer is that key's; a signed URL's is everybody's who has the URL, until it ends.
void tell_caches(Response& response, const Caller& caller, std::int64_t now_s) {
  std::string* control = field_of(response, "Cache-Control");
  if (control == nullptr) {
    if (response.content_type.empty()) return;
    control = &response.headers.emplace_back("Cache-Control", "").second;
  }
  if (control->starts_with("no-store")) return;
  if (caller.signed_until)
    *control = "public, max-age=" +
               std::to_string(std::max(std::int64_t{0}, *caller.signed_until - now_s));
  else if (control->starts_with("public")) control->replace(0, 6, "private");
  else control->insert(0, control->empty() ? "private" : "private, ");
}

}  // namespace

std::int64_t system_time() {
  using namespace std::chrono;
  return duration_cast<nanoseconds>(system_clock::now().time_since_epoch()).count();
}

Access::Access(const Config& config, Metrics& metrics, Now now, std::unique_ptr<Quotas> quotas)
    : config_(config),
      metrics_(metrics),
      now_(std::move(now)),
      quotas_(std::move(quotas)),
      ring_(std::make_shared<const KeyRing>(config)) {}

void Access::reload() {
  auto read = std::make_shared<const KeyRing>(config_);
  const std::lock_guard lock(mutex_);
  ring_ = std::move(read);
}

std::shared_ptr<const KeyRing> Access::ring() const {
  const std::lock_guard lock(mutex_);
  return ring_;
}

void Access::identify(Request& request) const {
  request.caller = take_caller(request, ring(), now_() / one_second);
  if (request.caller && request.caller->entry) request.key = request.caller->entry->id.text;
}

std::shared_ptr<const KeyEntry> Access::entry_for(const Request& request) const {
  if (request.caller) return request.caller->entry;
  const auto ring = this->ring();
  return {ring, ring->anonymous()};
}

std::shared_ptr<const KeyEntry> Access::entry_called(const std::string& key) const {
  const auto ring = this->ring();
  return {ring, key.empty() ? ring->anonymous() : ring->find(key)};
}

void Access::check_rights(const Request& request, const std::vector<Right>& needs) const {
  if (request.caller && !request.caller->entry)
    refuse_unauthorized(request.caller->why, request.caller->detail);
  const auto entry = entry_for(request);
  for (const Right right : needs) {
    if (entry ? entry->has(right) : ring()->is_open() && right != Right::admin) continue;
    const std::string name = '"' + std::string(name_of(right)) + '"';
    if (request.key.empty())
      refuse_unauthorized("none", "a key with the right " + name +
                                      " is needed: Authorization: Bearer ID.SECRET (option "
                                      "TIA_KEYS_FILE)");
    throw AccessRefusal("forbidden", "right", "the key " + request.key + " has no right " + name);
  }
}

void Access::admit(const Request& request, const std::vector<Right>& needs) {
  if (needs.empty()) return;
  try {
    check_rights(request, needs);
    const auto entry = entry_for(request);
    const auto left = entry ? requests_left(*entry, true) : std::nullopt;
    if (left && !left->is_taken)
      refuse_quota("requests", "the key has no request left for now", seconds_up(left->wait));
  } catch (const AccessRefusal& refusal) {
    metrics_.count_refusal(request.key, refusal.why());
    throw;
  }
}

bool Access::takes(const Request& request, const std::vector<Right>& needs) {
  try {
    check_rights(request, needs);
  } catch (const AccessRefusal&) {
    return false;
  }
  const auto entry = entry_for(request);
  if (!entry || !entry->requests_per_s) return true;
  return !quotas_->may_wait() && requests_left(*entry, true)->is_taken;
}

void Access::check_owner(const Request& request, const std::string& owner) {
  if (owner.empty() || owner == request.key) return;
  const auto entry = entry_for(request);
  if (entry && entry->has(Right::admin)) return;
  metrics_.count_refusal(request.key, "owner");
  throw AccessRefusal("forbidden", "owner", "it is another key's, which takes the right \"admin\"");
}

std::optional<RequestsLeft> Access::requests_left(const KeyEntry& entry, bool take) {
  const auto rate = rate_of(entry);
  if (!rate) return std::nullopt;
  return take ? quotas_->take(entry.id.text, *rate, now_())
              : quotas_->look(entry.id.text, *rate, now_());
}

std::int64_t Access::day() const { return now_() / one_second / day_s; }
std::int64_t Access::seconds_to_midnight() const { return day_s - now_() / one_second % day_s; }

void Access::check_rays(const std::string& key, double rays) {
  const auto entry = entry_called(key);
  if (!entry || !entry->rays_per_day) return;
  const std::int64_t left = rays_left(*entry, quotas_->add_rays(entry->id.text, day(), 0));
  if (rays <= static_cast<double>(left)) return;
  metrics_.count_refusal(key, "rays");
  refuse_quota("rays",
               "the key has " + std::to_string(left) + " of its " +
                   std::to_string(*entry->rays_per_day) +
                   " rays left today; this takes more, cached pictures none",
               seconds_to_midnight());
}

void Access::charge(const std::string& key, std::int64_t rays) {
  if (rays <= 0) return;
  const auto entry = entry_called(key);
  if (entry) quotas_->add_rays(entry->id.text, day(), rays);
  metrics_.count_rays_of(key, rays);
}

// Source: draft-ietf-httpapi-ratelimit-headers-10, 3 and 4: q a quota, w its window in seconds, r
// what is left, t the seconds until there is all of it again.
void Access::tell(Response& response, const Request& request) {
  const auto entry = entry_for(request);
  if (request.caller && entry) tell_caches(response, *request.caller, now_() / one_second);
  const bool is_public = request.caller && request.caller->signed_until;
  if (!entry || is_public) return;
  std::string policy, left;
  const auto add = [&](const char* name, std::int64_t quota, std::int64_t window, std::int64_t rest,
                       std::int64_t until) {
    const std::string begin = (policy.empty() ? "\"" : ", \"") + std::string(name) + "\";";
    policy += begin + "q=" + std::to_string(quota) + ";w=" + std::to_string(window);
    left += begin + "r=" + std::to_string(rest) + ";t=" + std::to_string(until);
  };
  if (const auto rate = rate_of(*entry)) {
    const RequestsLeft now = *requests_left(*entry, false);
    add("requests", rate->burst, seconds_up(rate->refill()), now.left, seconds_up(now.to_full));
  }
  if (entry->rays_per_day)
    add("rays", *entry->rays_per_day, day_s,
        rays_left(*entry, quotas_->rays(entry->id.text, day())), seconds_to_midnight());
  if (policy.empty()) return;
  response.headers.emplace_back("RateLimit-Policy", policy);
  response.headers.emplace_back("RateLimit", left);
}

}  // namespace tia::server
