// What a farm puts right, as scripts: results that are lost, parts that were forgotten; and what
// clients lend to its jobs.
#include "server/jobs/redis_scripts.h"

namespace tia::server {

// A part that is done and has no result waits again; what puts the parts together waits for it.
const char* const redis_undo_words = R"lua(
local function undo(id, n, row)
  local parts = number(id, 'parts')
  local join = part(id, parts)
  if join.state == 'leased' then
    release(id, parts, join)
    join.state = 'waiting'
    keep(id, parts, join)
  end
  call('LREM', P .. 'joins:' .. word(id, 'version'), 1, id)
  call('HDEL', key(id) .. ':results', n)
  local told = call('HGET', key(id) .. ':outside', n)
  if told then drop_blob(told) end
  call('HDEL', key(id) .. ':outside', n)
  hold(id, 0 - row.bytes)
  local kinds, i = {'primary', 'shadow', 'reflection', 'refraction', 'cut'}, 1
  for count in string.gmatch(string.match(row.place, '"counted":%[([^%]]*)') or '', '[^,]+') do
    add(id, kinds[i], 0 - count)
    i = i + 1
  end
  row.sha256, row.first = '', ''
  move(id, n, 'done', 'waiting')
  put_back(id, n, row)
  changed(id)
end
)lua";

// id, part, where its result is told to be. Returns: 1 it is drawn again; 0 its job has ended;
// 2 it is told otherwise by now.
const char* const redis_redo_text = R"lua(
local id, n = ARGV[11], tonumber(ARGV[12])
if call('HGET', key(id) .. ':outside', n) ~= ARGV[13] then return 2 end
if not is_open(id) then return 0 end
undo(id, n, part(id, n))
return 1
)lua";

// Holds each unfinished job's counts against what there is. Returns: how much of it was put right,
// at most a thousand at once.
const char* const redis_mend_text = R"lua(
local mended = 0
local function lacks(list, what) return not call('LPOS', list, what) end
local function has_result(id, n)
  return call('HEXISTS', key(id) .. ':results', n) + call('HEXISTS', key(id) .. ':outside', n) > 0
end
local function mend_results(id)
  local have = call('HLEN', key(id) .. ':results') + call('HLEN', key(id) .. ':outside')
  if have >= number(id, 'done') then return end
  for n = 0, number(id, 'parts') - 1 do
    local row = part(id, n)
    if mended < 1000 and row.state == 'done' and not has_result(id, n) then
      undo(id, n, row)
      mended = mended + 1
    end
  end
end
local function mend_leases(id)
  for _, each in ipairs(call('SMEMBERS', key(id) .. ':leased')) do
    local n = tonumber(each)
    local row = part(id, n)
    local queue = stream(row.queue, version)
    if row.state == 'leased' and #call('XRANGE', queue, row.entry, row.entry) == 0 then
      release(id, n, row)
      move(id, n, 'leased', 'waiting')
      put_back(id, n, row)
      mended = mended + 1
    end
  end
end
local function mend_turns(id)
  local owners, jobs, owner = turns(id)
  if not has_parts(id) or not (lacks(jobs, id) or lacks(owners, owner)) then return end
  call('HSET', key(id), 'listed', 1)
  if lacks(jobs, id) then call('RPUSH', jobs, id) end
  if lacks(owners, owner) then call('RPUSH', owners, owner) end
  wake(id)
  mended = mended + 1
end
local function mend_joins(id)
  local parts = number(id, 'parts')
  if word(id, 'joins') ~= '1' or number(id, 'done') < parts then return end
  local joins = P .. 'joins:' .. version
  if part(id, parts).state == 'leased' or not lacks(joins, id) then return end
  call('RPUSH', joins, id)
  changed(id)
  mended = mended + 1
end
for _, id in ipairs(call('ZRANGE', P .. 'open', 0, -1)) do
  if word(id, 'version') == version then
    mend_results(id)
    mend_leases(id)
    mend_turns(id)
    mend_joins(id)
  end
end
return mended
)lua";

// name, where it is or '' to look only, bytes. Returns: where it is; '' nowhere; full.
const char* const redis_lend_text = R"lua(
local name, at, bytes = ARGV[11], ARGV[12], tonumber(ARGV[13])
local known = call('HGET', P .. 'lent', name)
if not known then
  if at == '' then return '' end
  if not make_room(bytes) then return 'full' end
  call('HSET', P .. 'lent', name, at)
  call('PERSIST', P .. 'blob:' .. string.match(at, '^%S+'))
  total('held', bytes)
  known = at
end
call('ZADD', P .. 'lent:used', now, name)
return known
)lua";

// What no job needs goes as long after the last one as results do. Returns: where it is.
const char* const redis_unlend_text = R"lua(
for _, id in ipairs(call('ZRANGE', P .. 'open', 0, -1)) do
  for name in string.gmatch(word(id, 'needs'), '%S+') do
    if call('HEXISTS', P .. 'lent', name) == 1 then call('ZADD', P .. 'lent:used', now, name) end
  end
end
local found = {}
for _, name in ipairs(call('ZRANGEBYSCORE', P .. 'lent:used', '-inf', now - keep_ms,
                           'LIMIT', 0, 100)) do
  local at = call('HGET', P .. 'lent', name)
  total('held', 0 - string.match(at, '%d+$'))
  call('HDEL', P .. 'lent', name)
  call('ZREM', P .. 'lent:used', name)
  table.insert(found, at)
end
return found
)lua";

// job, the count that it was told by: nothing has been dropped of it since.
const char* const redis_swept_text = R"lua(
local dropped = KEYS[1] .. 'dropped'
if redis.call('ZSCORE', dropped, ARGV[1]) == ARGV[2] then redis.call('ZREM', dropped, ARGV[1]) end
return 1
)lua";

// Returns: keys and rays, which are the asker's to charge.
const char* const redis_charges_text = R"lua(
local charges = redis.call('HGETALL', KEYS[1] .. 'charges')
redis.call('DEL', KEYS[1] .. 'charges')
return charges
)lua";

}  // namespace tia::server
