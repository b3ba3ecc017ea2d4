// Pictures whose memory nobody could foresee.
#pragma once

#include <new>
#include <stop_token>

#include "server/operation/memory_account.h"
#include "server/stores/picture.h"

namespace tia::server {

/// Does it, and where the account had no memory for what nobody could foresee, once more when twice
/// as much is free. Errors: what it throws; HttpError (busy, too-large) in std::bad_alloc's place.
template <class Attempt>
Picture with_memory_for(const Attempt& attempt, const std::stop_token& stop) {
  MemoryClaim* const claim = MemoryClaim::current();
  if (claim == nullptr) return attempt();
  try {
    return attempt();
  } catch (const std::bad_alloc&) {
    if (!claim->was_refused()) throw;
    claim->settle();
    claim->reserve(2 * claim->most_used(), "this picture", stop);
  }
  try {
    return attempt();
  } catch (const std::bad_alloc&) {
    throw claim->refusal();
  }
}

}  // namespace tia::server
