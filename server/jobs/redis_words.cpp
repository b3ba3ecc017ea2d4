// What the scripts share: rows, counts, turns and leases.
#include "server/jobs/redis_scripts.h"

namespace tia::server {

// The arguments that every script has; jobs' fields; rows of parts, whose fields stand between unit
// separators.
const char* const redis_job_words = R"lua(
local P, call = KEYS[1], redis.call
local now, keep_ms, tries = tonumber(ARGV[1]), tonumber(ARGV[2]), tonumber(ARGV[3])
local most_bytes, most_jobs = tonumber(ARGV[4]), tonumber(ARGV[5])
local version, worker, lease_ms, dead_problem, role = ARGV[6], ARGV[7], ARGV[8], ARGV[9], ARGV[10]
local own_bytes = 1024

local function key(id) return P .. 'job:' .. id end
local function word(id, field) return call('HGET', key(id), field) or '' end
local function number(id, field) return tonumber(call('HGET', key(id), field) or 0) end
local function add(id, field, more) return call('HINCRBY', key(id), field, more) end
local function total_of(field) return tonumber(call('HGET', P .. 'totals', field) or 0) end
local function total(field, more) return call('HINCRBY', P .. 'totals', field, more) end
local function is_open(id) return call('ZSCORE', P .. 'open', id) ~= false end

local names = {'state', 'tries', 'worker', 'etag', 'place', 'ms', 'rays', 'bytes', 'type',
               'sha256', 'first', 'entry', 'queue'}
local function part(id, n)
  local row, i = {}, 1
  local text = call('HGET', key(id) .. ':parts', n) or 'waiting\0310'
  for field in string.gmatch(text .. '\031', '([^\031]*)\031') do
    row[names[i]] = field
    i = i + 1
  end
  row.tries = tonumber(row.tries)
  return row
end
local function keep(id, n, row)
  local fields = {}
  for i, name in ipairs(names) do fields[i] = row[name] or '' end
  call('HSET', key(id) .. ':parts', n, table.concat(fields, '\031'))
end
-- A part from one state's count to another's. What puts them together is none.
local function move(id, n, from, to)
  if n >= number(id, 'parts') then return end
  add(id, from, -1)
  add(id, to, 1)
  if from == 'waiting' or from == 'leased' then total(from, -1) end
  if to == 'waiting' or to == 'leased' then total(to, 1) end
end
-- (What is taken away is written 0 - x: -0 is no whole number to Redis.)
-- Sums of an account: of a key, or of all together who have none. Of none there is no word.
local function account(id)
  local owner = word(id, 'owner')
  return string.sub(owner, 1, 4) == 'key ' and owner or 'anonymous'
end
local function sum_of(what, id) return tonumber(call('HGET', P .. what, account(id)) or 0) end
local function add_to(what, id, more)
  if call('HINCRBY', P .. what, account(id), more) <= 0 then call('HDEL', P .. what, account(id)) end
end
local function hold(id, more)
  add(id, 'held', more)
  total('held', more)
  add_to('held', id, more)
end
local function set_state(id, state)
  local old = word(id, 'state')
  if old ~= '' then call('HINCRBY', P .. 'states', old, -1) end
  call('HINCRBY', P .. 'states', state, 1)
  call('HSET', key(id), 'state', state)
end

local function changed(id) call('PUBLISH', P .. 'changed', id) end
-- Told to workers alone, which would have much to hear otherwise: there is more to do, or less.
local function wake(id) call('PUBLISH', P .. 'work', id) end
local function tell(id, name, data)
  call('XADD', key(id) .. ':events', 'MAXLEN', 1000, add(id, 'events', 1) .. '-0',
       'name', name, 'data', data)
end
local function tell_state(id) tell(id, 'state', '{"state":"' .. word(id, 'state') .. '"}') end
local function tell_progress(id, is_last)
  if not is_last and now - number(id, 'told') < 250 then return end
  call('HSET', key(id), 'told', now)
  local parts, done, rays, left = number(id, 'parts'), number(id, 'done'), 0, 'null'
  for _, kind in ipairs({'primary', 'shadow', 'reflection', 'refraction'}) do
    rays = rays + number(id, kind)
  end
  if done > 0 then
    left = string.format('%.3f', math.max(now - number(id, 'started'), 0) / 1000 *
                                     (parts - done) / done)
  end
  tell(id, 'progress', string.format('{"parts":%d,"done":%d,"failed":%d,"rays":%.0f,' ..
       '"remaining_s":%s}', parts, done, number(id, 'dead'), rays, left))
end
)lua";

// Whose turn it is, and the leases.
const char* const redis_turn_words = R"lua(
local function turns(id)
  local of = call('HMGET', key(id), 'version', 'priority', 'owner')
  local owners = P .. 'turns:' .. of[1] .. ':' .. of[2]
  return owners, owners .. ':' .. of[3], of[3]
end
local function has_parts(id)
  return number(id, 'next') < number(id, 'parts') or call('EXISTS', key(id) .. ':back') == 1
end
local function enlist(id)
  if call('HSETNX', key(id), 'listed', 1) == 0 then return end
  wake(id)
  local owners, jobs, owner = turns(id)
  if call('RPUSH', jobs, id) == 1 then call('RPUSH', owners, owner) end
end
local function delist(id)
  if call('HDEL', key(id), 'listed') == 0 then return end
  local owners, jobs, owner = turns(id)
  call('LREM', jobs, 1, id)
  if call('EXISTS', jobs) == 0 then call('LREM', owners, 1, owner) end
end
-- Behind all others.
local function had_turn(id)
  local owners, jobs, owner = turns(id)
  if has_parts(id) then
    call('LREM', jobs, 1, id)
    call('RPUSH', jobs, id)
    call('LREM', owners, 1, owner)
    call('RPUSH', owners, owner)
  else
    delist(id)
    if call('LREM', owners, 1, owner) == 1 then call('RPUSH', owners, owner) end
  end
end

local function stream(queue, of) return P .. 'q:' .. of .. ':' .. queue end
-- The lease's end, whatever comes of it.
local function release(id, n, row)
  local queue = stream(row.queue, word(id, 'version'))
  call('XACK', queue, 'workers', row.entry)
  call('XDEL', queue, row.entry)
  call('SREM', key(id) .. ':leased', n)
  row.entry = ''
end
-- It waits again.
local function put_back(id, n, row)
  row.state = 'waiting'
  keep(id, n, row)
  if n < number(id, 'parts') then
    call('ZADD', key(id) .. ':back', n, n)
    enlist(id)
  else
    call('RPUSH', P .. 'joins:' .. word(id, 'version'), id)
  end
end
-- Tries of one plan and of the next are told apart by thousands.
local function attempt_of(id, row) return number(id, 'generation') * 1000 + row.tries end
local function is_leased(id, row, attempt)
  return row.state == 'leased' and attempt_of(id, row) == attempt and is_open(id)
end

-- Who was heard of within a lease's time.
local function time_ms()
  local time = call('TIME')
  return time[1] * 1000 + math.floor(time[2] / 1000)
end
local function heard() call('ZADD', P .. 'workers:' .. version, time_ms(), worker) end
local function workers(of)
  return call('ZCOUNT', P .. 'workers:' .. of, time_ms() - lease_ms, '+inf')
end
)lua";

}  // namespace tia::server
