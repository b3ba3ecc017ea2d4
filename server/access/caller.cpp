#include "server/access/caller.h"

#include <utility>

#include "server/access/secrets.h"
#include "server/access/signed_url.h"
#include "server/http/message.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

using SharedRing = std::shared_ptr<const KeyRing>;

// Source: RFC 6750, 2.1 and 3; the scheme's name is without case (RFC 9110, 11.1).
constexpr std::string_view bearer = "Bearer ";
bool is_bearer(std::string_view authorization) {
  return same_word(authorization.substr(0, bearer.size()), bearer);
}

Caller refused(std::string_view why, std::string detail) {
  return {.why = why, .detail = std::move(detail)};
}

bool has_ended(const KeyEntry& entry, std::int64_t seconds) {
  return entry.expires && seconds >= entry.expires->seconds;
}

// Unknown ids take as long as known ones, and are told in the same words.
Caller caller_by_key(std::string_view token, const SharedRing& ring, std::int64_t seconds) {
  const auto dot = token.find('.');
  if (dot == token.npos)
    return refused("form", "got no key, allowed: Authorization: Bearer ID.SECRET");
  const KeyEntry* const entry = ring->find(token.substr(0, dot));
  static const std::string nobody(64, '-');
  const std::string digest = sha256_hex(token.substr(dot + 1));
  const std::string& kept = entry != nullptr && entry->sha256 ? *entry->sha256 : nobody;
  if (!same_secret(digest, kept))
    return refused(&kept == &nobody ? "unknown" : "secret", "no key has this id and this secret");
  if (has_ended(*entry, seconds)) return refused("expired", "the key has ended");
  return {.entry = {ring, entry}};
}

// Expired is what is on or after that second. Source: RFC 7519, 4.1.4, whose word `exp` is.
Caller caller_by_url(const UrlSignature& signature, const std::string& method,
                     const SharedRing& ring, std::int64_t seconds) {
  if (!signature.is_in_form)
    return refused("form", "a signed URL ends with exp=UNIX&kid=K&sig=S, and has each once");
  if (method != "GET" && method != "HEAD")
    return refused("method", "a signed URL is for GET and HEAD");
  const SigningKey* const key = ring->signing_key(signature.kid);
  if (key == nullptr || !is_signed_by(signature, key->secret))
    return refused(key == nullptr ? "unknown" : "signature",
                   "the URL is not signed by this server");
  const KeyEntry* const owner = ring->find(key->owner);
  if (seconds >= signature.expires || has_ended(*owner, seconds))
    return refused("expired", "the signed URL has ended");
  return {.entry = {ring, owner}, .signed_until = signature.expires};
}

}  // namespace

std::shared_ptr<const Caller> take_caller(Request& request, const SharedRing& ring,
                                          std::int64_t seconds) {
  if (const auto signature = take_signature(request.target))
    return std::make_shared<const Caller>(caller_by_url(*signature, request.method, ring, seconds));
  const std::string_view authorization = request.header("Authorization");
  if (ring->is_open() || !is_bearer(authorization)) return nullptr;
  return std::make_shared<const Caller>(
      caller_by_key(trimmed(authorization.substr(bearer.size())), ring, seconds));
}

}  // namespace tia::server
