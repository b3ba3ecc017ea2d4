// What becomes of parts, as scripts: claimed, kept alive, finished, lost.
#include "server/jobs/redis_scripts.h"

namespace tia::server {

// First what nobody has been heard of for too long, then by turns. Returns: job, part, attempt.
const char* const redis_claim_text = R"lua(
if call('ZSCORE', P .. 'banned', worker) then return {'banned'} end
if role ~= 'joins' then heard() end
local order = {'high', 'normal', 'low'}
if total_of('claims') % 8 == 7 then order = {'low', 'high', 'normal'} end
if role == 'joins' then order = {'joins'} end
if role == 'all' then table.insert(order, 1, 'joins') end
for _, queue in ipairs(order) do
  if call('EXISTS', stream(queue, version)) == 0 then
    call('XGROUP', 'CREATE', stream(queue, version), 'workers', '$', 'MKSTREAM')
  end
end

local function lease(queue, entry, id, n)
  local row = part(id, n)
  local from = row.state
  row.state, row.tries, row.worker = 'leased', row.tries + 1, worker
  row.entry, row.queue = entry, queue
  keep(id, n, row)
  if from == 'waiting' then move(id, n, 'waiting', 'leased') end
  call('SADD', key(id) .. ':leased', n)
  if word(id, 'state') == 'queued' then
    set_state(id, 'running')
    call('HSET', key(id), 'started', now)
    tell_state(id)
  end
  changed(id)
  return {id, n, attempt_of(id, row)}
end

for _, queue in ipairs(order) do
  local cursor = '0-0'
  repeat
    local got = call('XAUTOCLAIM', stream(queue, version), 'workers', worker, lease_ms, cursor,
                     'COUNT', 1)
    cursor = got[1]
    local entry = got[2][1]
    if entry then
      local id, n = entry[2][2], tonumber(entry[2][4])
      local row = part(id, n)
      total('reclaims', 1)
      if row.tries < tries then return lease(queue, entry[1], id, n) end
      lose_try(id, n, row)
    end
  until cursor == '0-0'
end

-- An audited part is for another worker than the first, while there is one.
local is_alone = role == 'joins' or workers(version) < 2
local function next_part(id)
  for _, n in ipairs(call('ZRANGE', key(id) .. ':back', 0, 15)) do
    if is_alone or part(id, n).first ~= worker then
      call('ZREM', key(id) .. ':back', n)
      return tonumber(n)
    end
  end
  local next = number(id, 'next')
  if next == number(id, 'parts') then return nil end
  add(id, 'next', 1)
  return next
end
local function next_of(queue)
  if queue == 'joins' then
    local id = call('LPOP', P .. 'joins:' .. version)
    if id then return id, number(id, 'parts') end
    return nil
  end
  local owners = P .. 'turns:' .. version .. ':' .. queue
  for _, owner in ipairs(call('LRANGE', owners, 0, -1)) do
    for _, id in ipairs(call('LRANGE', owners .. ':' .. owner, 0, -1)) do
      local n = next_part(id)
      if n then
        had_turn(id)
        return id, n
      end
    end
  end
end

for _, queue in ipairs(order) do
  local id, n = next_of(queue)
  if id then
    if queue ~= 'joins' then total('claims', 1) end
    local to = stream(queue, version)
    call('XADD', to, '*', 'job', id, 'n', n)
    local read = call('XREADGROUP', 'GROUP', 'workers', worker, 'COUNT', 1, 'STREAMS', to, '>')
    return lease(queue, read[1][2][1][1], id, n)
  end
end
return {}
)lua";

// id, part, attempt. Returns: whether it is still wanted.
const char* const redis_heartbeat_text = R"lua(
local id, n = ARGV[11], tonumber(ARGV[12])
local row = part(id, n)
if not is_leased(id, row, tonumber(ARGV[13])) then return 0 end
call('XCLAIM', stream(row.queue, word(id, 'version')), 'workers', row.worker, 0, row.entry,
     'JUSTID')
if role ~= 'joins' then heard() end
return 1
)lua";

// id, part, attempt, bytes, their SHA-256, etag, type, place, ms, rays of all kinds, then of each,
// whether it is audited, the problem of a mismatch, the event, where its bytes are outside or '',
// how many they are, rays to be charged. Returns: what has become of it.
const char* const redis_finish_text = R"lua(
local id, n, attempt = ARGV[11], tonumber(ARGV[12]), tonumber(ARGV[13])
local bytes, sha256, outside, size = ARGV[14], ARGV[15], ARGV[29], tonumber(ARGV[30])
local row = part(id, n)
local is_wanted = is_leased(id, row, attempt)
local function mismatch(other)
  total('mismatches', 1)
  for _, each in ipairs({worker, other}) do call('ZADD', P .. 'banned', time_ms(), each) end
  if is_open(id) then
    local what = string.gsub(string.gsub(ARGV[27], '@PART@', n), '@OTHER@', other)
    fail_with(id, what)
  end
  return 'mismatch'
end
if not is_wanted then
  local is_same_plan = math.floor(attempt / 1000) == number(id, 'generation')
  if row.state == 'done' and is_same_plan and row.sha256 ~= sha256 then
    return mismatch(row.worker)
  end
  return 'late'
end
if row.first ~= '' then
  total('audits', 1)
  if row.sha256 ~= sha256 then return mismatch(row.first) end
elseif ARGV[26] == '1' and workers(version) >= 2 then
  release(id, n, row)
  row.first, row.sha256, row.tries = worker, sha256, row.tries - 1
  move(id, n, 'leased', 'waiting')
  put_back(id, n, row)
  changed(id)
  return 'audited'
end
if not make_room(size) then return 'full' end

release(id, n, row)
row.state, row.sha256, row.bytes = 'done', sha256, size
row.etag, row.type, row.place, row.ms, row.rays = unpack(ARGV, 16, 20)
keep(id, n, row)
if outside == '' then
  call('HSET', key(id) .. ':results', n, bytes)
else
  call('HSET', key(id) .. ':outside', n, outside)
  local is_here = call('PERSIST', P .. 'blob:' .. string.match(outside, '^%S+')) == 1
  if not is_here then call('HSET', key(id), 'outside', 1) end
end
hold(id, size)
local parts, joins = number(id, 'parts'), word(id, 'joins') == '1'
if n < parts then
  move(id, n, 'leased', 'done')
  for i, kind in ipairs({'primary', 'shadow', 'reflection', 'refraction', 'cut'}) do
    add(id, kind, ARGV[20 + i])
  end
  local owner = string.match(word(id, 'owner'), '^key (.*)')
  if owner and role == 'draws' then call('HINCRBY', P .. 'charges', owner, ARGV[31]) end
  tell(id, 'part', ARGV[28])
  tell_progress(id, number(id, 'done') == parts)
end
if n == parts or (not joins and number(id, 'done') == parts) then
  close(id, 'done')
else
  if joins and number(id, 'done') == parts then
    call('RPUSH', P .. 'joins:' .. word(id, 'version'), id)
  end
  changed(id)
end
return 'done'
)lua";

// id, part, attempt, whether it is given back untouched.
const char* const redis_lose_text = R"lua(
local id, n = ARGV[11], tonumber(ARGV[12])
local row = part(id, n)
if not is_leased(id, row, tonumber(ARGV[13])) then return 0 end
if ARGV[14] == '1' then row.tries = row.tries - 1 end
lose_try(id, n, row)
return 1
)lua";

}  // namespace tia::server
