// What the scripts share: how jobs end, and what they leave.
#include "server/jobs/redis_scripts.h"

namespace tia::server {

const char* const redis_end_words = R"lua(
-- The store may have what nobody needs any more: by a count, so that none is forgotten that was told
-- meanwhile.
local function leave_outside(id)
  if word(id, 'outside') == '1' then call('ZADD', P .. 'dropped', total('drops', 1), id) end
end
-- Where there is no store it is in Redis, and goes by this.
local function drop_blob(told) call('UNLINK', P .. 'blob:' .. string.match(told, '^%S+')) end
local function drop_blobs(id)
  for _, told in ipairs(call('HVALS', key(id) .. ':outside')) do drop_blob(told) end
end
local function drop_of(hash, id, spares, bytes)
  local all, dropped = key(id) .. hash, 0
  for _, n in ipairs(call('HKEYS', all)) do
    if n ~= spares then
      dropped = dropped + bytes(all, n)
      if spares then call('HDEL', all, n) end
    end
  end
  if not spares then call('UNLINK', all) end
  return dropped
end
local function drop_results(id, spares)
  local inside = drop_of(':results', id, spares, function(all, n)
    return call('HSTRLEN', all, n)
  end)
  local outside = drop_of(':outside', id, spares, function(all, n)
    local told = call('HGET', all, n)
    drop_blob(told)
    return string.match(told, '%d+$')
  end)
  hold(id, 0 - inside - outside)
end
-- What others are still at is not waited for. Of the results those stay that are asked for.
local function close(id, state)
  for _, each in ipairs(call('SMEMBERS', key(id) .. ':leased')) do
    local n = tonumber(each)
    local row = part(id, n)
    release(id, n, row)
    row.state, row.tries = 'waiting', row.tries - 1
    keep(id, n, row)
    move(id, n, 'leased', 'waiting')
  end
  delist(id)
  call('LREM', P .. 'joins:' .. word(id, 'version'), 1, id)
  call('DEL', key(id) .. ':back')
  total('waiting', 0 - number(id, 'waiting'))
  call('ZREM', P .. 'open', id)
  add_to('unfinished', id, -1)
  call('ZREM', P .. 'deadlines', id)
  local expires = now + (tonumber(word(id, 'keep_ms')) or keep_ms)  -- as who took it has said
  call('ZADD', P .. 'closed', expires, id)
  set_state(id, state)
  call('HSET', key(id), 'finished', now, 'expires', expires)
  local joins, parts = word(id, 'joins') == '1', word(id, 'parts')
  if state ~= 'done' then
    drop_results(id)
  else
    if joins then drop_results(id, parts) end
    local row = part(id, joins and parts or 0)
    call('HSET', key(id), 'etag', row.etag, 'type', row.type, 'bytes', row.bytes)
  end
  leave_outside(id)
  tell_state(id)
  changed(id)
  wake(id)
end
local function fail_with(id, problem)
  call('HSET', key(id), 'problem', problem)
  close(id, 'failed')
end
-- A try has ended without a result: the part waits again, or is dead and ends its job.
local function lose_try(id, n, row)
  release(id, n, row)
  if row.tries < tries then
    move(id, n, 'leased', 'waiting')
    put_back(id, n, row)
    changed(id)
    return
  end
  row.state = 'dead'
  keep(id, n, row)
  move(id, n, 'leased', 'dead')
  tell(id, 'part', '{"n":' .. n .. ',"state":"dead"}')
  local what = n < number(id, 'parts') and 'part ' .. n or 'putting the parts together'
  fail_with(id, (string.gsub(dead_problem, '@PART@', what)))
end

-- What it was asked for stays known for a while, so that who asks for it learns that it is gone.
local function forget_key(id)
  local known = word(id, 'key_digest')
  if known ~= '' then call('HDEL', P .. 'keys', known) end
end
local function let_go(id)
  forget_key(id)
  leave_outside(id)
  drop_blobs(id)
  call('UNLINK', key(id) .. ':results', key(id) .. ':outside', key(id) .. ':parts')
  hold(id, own_bytes - number(id, 'held'))
  call('HSET', key(id), 'gone', 1, 'request', '', 'plan', '', 'key', '', 'key_digest', '')
  call('ZREM', P .. 'closed', id)
  call('ZADD', P .. 'gone', number(id, 'expires') + keep_ms, id)
  changed(id)
end
local function remove(id)
  forget_key(id)
  hold(id, 0 - number(id, 'held'))
  call('HINCRBY', P .. 'states', word(id, 'state'), -1)
  call('ZREM', P .. 'closed', id)
  call('ZREM', P .. 'gone', id)
  leave_outside(id)
  drop_blobs(id)
  call('UNLINK', key(id), key(id) .. ':results', key(id) .. ':outside', key(id) .. ':parts',
       key(id) .. ':events')
  changed(id)
end
-- What has been finished for longest goes first; nothing where that would not do.
local function make_room(more)
  local over, going = total_of('held') + more - most_bytes, {}
  if over <= 0 then return true end
  for _, id in ipairs(call('ZRANGE', P .. 'closed', 0, -1)) do
    over = over - number(id, 'held') + own_bytes
    table.insert(going, id)
    if over <= 0 then
      for _, each in ipairs(going) do let_go(each) end
      return true
    end
  end
  return false
end
)lua";

}  // namespace tia::server
