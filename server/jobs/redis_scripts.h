// The changes of state of a farm's jobs as scripts in Lua: each is done whole or not at all, and is
// on Redis' disk before it is answered.
//
// Keys, all in one slot, after {tia}:1: (the layout's number; programs of several versions share a
// farm, but no queue):
//   totals states     hashes: bytes held, parts waiting and leased, claims, reclaims; jobs by state
//   open closed gone  sorted sets of jobs: unfinished by creation, finished and let go by when they
//   deadlines         go on; those that have a deadline
//   keys              hash: Idempotency-Key's digest -> job
//   unfinished held   hashes: of each account its unfinished jobs and the bytes of all of them
//   turns:V:PRIORITY  list of owners whose turn it is, and :OWNER of each its jobs, of version V
//   q:V:QUEUE         stream of what is leased, group `workers`; queues: priorities, and joins
//   joins:V           list of jobs whose parts are all there to be put together
//   job:ID            hash; :parts hash of rows, :results hash of bytes, :back sorted set of parts
//                     that came back, :leased set, :events stream, :outside hash of results that
//                     are in the store: name, SHA-256, bytes
//   dropped           sorted set of jobs of which the store may have what nobody needs, by a count
//   lent lent:used    hash of what clients have sent and jobs name, as :outside; by its last use
//   charges           hash: key -> rays that were traced for it and nobody has charged yet
//   blob:NAME         what is lent, where there is no store
//   changed work      channels: jobs that have changed, and those that give workers more or less to
//   do workers:V banned  sorted sets: when a worker was last heard of; those that drew other bytes
#pragma once

#include "server/stores/redis.h"

namespace tia::server {

/// RedisScripts. Their arguments: `common` of each, then its own (see the texts).
struct RedisScripts {
  RedisScripts();
  RedisScript submit, claim, heartbeat, finish, lose, fail, cancel, sweep, plan_anew, load, others,
      redo, mend, lend, unlend, swept, charges;
};

/// What each script begins with: the words that they share.
extern const char* const redis_job_words;
extern const char* const redis_turn_words;
extern const char* const redis_end_words;
/// What some of them go on with.
extern const char* const redis_claim_text;
extern const char* const redis_heartbeat_text;
extern const char* const redis_finish_text;
extern const char* const redis_lose_text;
extern const char* const redis_undo_words;
extern const char* const redis_redo_text;
extern const char* const redis_mend_text;
extern const char* const redis_lend_text;
extern const char* const redis_unlend_text;
extern const char* const redis_swept_text;
extern const char* const redis_charges_text;

}  // namespace tia::server
