#include "server/jobs/redis_scripts.h"

namespace tia::server {
namespace {

std::string script_text(const std::string& own) {
  return std::string(redis_job_words) + redis_turn_words + redis_end_words + own;
}

// id, digest of its key or '', digest, bytes, bytes of results, its owner's limits of unfinished
// jobs and of bytes or ''; then fields and values.
constexpr const char* submit_text = R"lua(
local id, key_digest, digest, bytes, more = unpack(ARGV, 11, 15)
local own_jobs, own_most = tonumber(ARGV[16]), tonumber(ARGV[17])
if call('EXISTS', key(id)) == 1 then return {'kept', id} end
local known = key_digest ~= '' and call('HGET', P .. 'keys', key_digest)
if known then
  if word(known, 'digest') ~= digest then return {'conflict'} end
  return {'kept', known}
end
if call('ZCARD', P .. 'open') >= most_jobs then return {'busy'} end
call('HSET', key(id), 'key_digest', key_digest, 'created', now, unpack(ARGV, 18))
local unfinished, held = sum_of('unfinished', id), sum_of('held', id)
if (own_jobs and unfinished >= own_jobs) or (own_most and held + bytes + more > own_most) then
  call('DEL', key(id))
  return {'quota', unfinished, held}
end
if not make_room(bytes + more) then
  call('DEL', key(id))
  return {'full', total_of('held')}
end
add_to('unfinished', id, 1)
local parts = number(id, 'parts')
call('HSET', key(id), 'waiting', parts)
total('waiting', parts)
hold(id, bytes)
call('ZADD', P .. 'open', now, id)
call('HSET', key(id), 'keep_ms', keep_ms)
if key_digest ~= '' then call('HSET', P .. 'keys', key_digest, id) end
if number(id, 'deadline') > 0 then call('ZADD', P .. 'deadlines', number(id, 'deadline'), id) end
set_state(id, 'queued')
enlist(id)
tell_state(id)
changed(id)
return {'kept', id}
)lua";

// id, problem.
constexpr const char* fail_text = R"lua(
if is_open(ARGV[11]) then fail_with(ARGV[11], ARGV[12]) end
return 1
)lua";

// id.
constexpr const char* cancel_text = R"lua(
local id = ARGV[11]
if call('EXISTS', key(id)) == 0 then return 'unknown' end
if is_open(id) then
  close(id, 'cancelled')
  return 'now'
end
remove(id)
return 'removed'
)lua";

// The problem of a deadline that is over. Returns: how many jobs it has changed, some at a time, so
// that nobody waits long.
constexpr const char* sweep_text = R"lua(
local count = 0
local function each(set, action)
  local ids = call('ZRANGEBYSCORE', P .. set, '-inf', now, 'LIMIT', 0, 100)
  for _, id in ipairs(ids) do action(id) end
  count = count + #ids
end
each('deadlines', function(id) fail_with(id, ARGV[11]) end)
each('closed', let_go)
each('gone', remove)
local day_ms = 86400000
call('ZREMRANGEBYSCORE', P .. 'workers:' .. version, '-inf', time_ms() - day_ms)
call('ZREMRANGEBYSCORE', P .. 'banned', '-inf', time_ms() - day_ms)
return count
)lua";

// id, bytes; then fields and values. Its old plan's leases end.
constexpr const char* plan_anew_text = R"lua(
local id = ARGV[11]
if not is_open(id) then return 0 end
for _, n in ipairs(call('SMEMBERS', key(id) .. ':leased')) do release(id, n, part(id, n)) end
delist(id)
call('LREM', P .. 'joins:' .. word(id, 'version'), 1, id)
drop_blobs(id)
call('UNLINK', key(id) .. ':results', key(id) .. ':outside', key(id) .. ':parts',
     key(id) .. ':back')
total('waiting', 0 - number(id, 'waiting'))
total('leased', 0 - number(id, 'leased'))
hold(id, ARGV[12] - number(id, 'held'))
call('HSET', key(id), 'leased', 0, 'done', 0, 'dead', 0, 'next', 0, 'started', 0, 'primary', 0,
     'shadow', 0, 'reflection', 0, 'refraction', 0, 'cut', 0, unpack(ARGV, 13))
local parts = number(id, 'parts')
call('HSET', key(id), 'waiting', parts)
total('waiting', parts)
add(id, 'generation', 1)
set_state(id, 'queued')
enlist(id)
tell_state(id)
tell_progress(id, true)
changed(id)
return 1
)lua";

// Returns: totals, when the oldest job was made that has a part to draw, how many are unfinished,
// workers; jobs by state.
constexpr const char* load_text = R"lua(
local oldest = 0
for _, id in ipairs(call('ZRANGE', P .. 'open', 0, -1)) do
  if number(id, 'waiting') > 0 then
    oldest = number(id, 'created')
    break
  end
end
local found = {total_of('waiting'), total_of('leased'), total_of('held'), total_of('reclaims'),
               total_of('mismatches'), total_of('audits'), oldest, call('ZCARD', P .. 'open'),
               workers(version)}
for _, state in ipairs({'queued', 'running', 'done', 'failed', 'cancelled'}) do
  table.insert(found, tonumber(call('HGET', P .. 'states', state) or 0))
end
return found
)lua";

// version. Returns: unfinished jobs of others that no worker draws any more. Who draws none itself
// takes them over for workers that are there.
constexpr const char* others_text = R"lua(
local found = {}
if role == 'joins' and workers(ARGV[11]) == 0 then return found end
for _, id in ipairs(call('ZRANGE', P .. 'open', 0, -1)) do
  local of = word(id, 'version')
  if of ~= ARGV[11] and workers(of) == 0 then table.insert(found, id) end
end
return found
)lua";

}  // namespace

RedisScripts::RedisScripts()
    : submit(script_text(submit_text)),
      claim(script_text(redis_claim_text)),
      heartbeat(script_text(redis_heartbeat_text)),
      finish(script_text(redis_finish_text)),
      lose(script_text(redis_lose_text)),
      fail(script_text(fail_text)),
      cancel(script_text(cancel_text)),
      sweep(script_text(sweep_text)),
      plan_anew(script_text(plan_anew_text)),
      load(script_text(load_text)),
      others(script_text(others_text)),
      redo(script_text(std::string(redis_undo_words) + redis_redo_text)),
      mend(script_text(std::string(redis_undo_words) + redis_mend_text)),
      lend(script_text(redis_lend_text)),
      unlend(script_text(redis_unlend_text)),
      swept(redis_swept_text),
      charges(redis_charges_text) {}

}  // namespace tia::server
