// What becomes of a job, as it is sent to who watches it.
#pragma once

#include <memory>

#include "server/jobs/board.h"
#include "server/jobs/store.h"

namespace tia::server {

/// Its events after that one as server-sent events, until its last one; a comment every 15 s.
/// Source: WHATWG HTML, 9.2. Errors: as Board::open.
std::shared_ptr<Feed> event_feed(const std::string& id, std::int64_t after, JobStore& store,
                                 Board& board);

/// Its status, once it is another one than this, or after so many seconds.
std::shared_ptr<Feed> status_feed(const Job& job, int most_seconds, JobStore& store, Board& board);

}  // namespace tia::server
