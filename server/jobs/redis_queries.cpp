// What a farm is asked for.
#include <algorithm>

#include "server/contract/problem.h"
#include "server/jobs/redis_fields.h"
#include "server/jobs/redis_jobs.h"

namespace tia::server {
namespace {

// Rows of parts that are asked for at once.
constexpr int rows_at_once = 1000;

}  // namespace

std::optional<Job> RedisJobs::find(const std::string& id) {
  const RedisReply reply = redis_.call({"HGETALL", key(id)});
  return reply.items.empty() ? std::nullopt : std::optional(job_of(reply));
}

std::vector<std::string> RedisJobs::ids(int first, int most) {
  std::vector<std::string> found;
  for (const char* set : {"open", "closed", "gone"})
    for (RedisReply& id : redis_.call({"ZREVRANGE", std::string(prefix) + set, "0", "-1"}).items)
      if (first-- <= 0 && static_cast<int>(found.size()) < most)
        found.push_back(std::move(id.words));
  return found;
}

OwnerSums RedisJobs::sums_of(const NewJob& job) {
  const std::string account = account_of(job);
  const auto sum = [&](const char* what) {
    const RedisReply number = redis_.call({"HGET", std::string(prefix) + what, account});
    return number.kind == RedisReply::text ? std::stoll(number.words) : 0;
  };
  return {sum("unfinished"), sum("held")};
}

std::vector<PartRow> RedisJobs::parts(const std::string& id, std::optional<PartState> state,
                                      int first, int most) {
  std::vector<PartRow> found;
  const auto job = find(id);
  if (!job || job->is_gone) return found;
  const std::string of = key(id) + ":parts";
  for (int n = std::max(first, 0); n < job->parts && static_cast<int>(found.size()) < most;) {
    std::vector<std::string> numbers;
    for (int i = n; i < job->parts && i < n + rows_at_once; ++i)
      numbers.push_back(std::to_string(i));
    std::vector<std::string_view> words{"HMGET", of};
    words.insert(words.end(), numbers.begin(), numbers.end());
    for (const RedisReply& row : redis_.call(words).items) {
      PartRow part = part_of(n++, row);
      if ((!state || part.state == *state) && static_cast<int>(found.size()) < most)
        found.push_back(std::move(part));
    }
  }
  return found;
}

std::optional<PartRow> RedisJobs::part(const std::string& id, int n) {
  const RedisReply row = redis_.call({"HGET", key(id) + ":parts", std::to_string(n)});
  return row.kind == RedisReply::text ? std::optional(part_of(n, row)) : std::nullopt;
}

std::optional<std::string> RedisJobs::result(const std::string& id, int n) {
  RedisReply bytes = redis_.call({"HGET", key(id) + ":results", std::to_string(n)});
  if (bytes.kind != RedisReply::text) return outside_result(id, n);
  return std::move(bytes.words);
}

std::vector<JobEvent> RedisJobs::events(const std::string& id, std::int64_t after, int most) {
  std::vector<JobEvent> found;
  const std::string of = key(id) + ":events", from = '(' + std::to_string(after) + "-0";
  const std::string count = std::to_string(most);
  for (RedisReply& each : redis_.call({"XRANGE", of, from, "+", "COUNT", count}).items) {
    if (each.items.size() != 2 || each.items[1].items.size() != 4)
      throw StorageError("the farm keeps an event that is none");
    auto& fields = each.items[1].items;
    found.push_back(
        {std::stoll(each.items[0].words), std::move(fields[1].words), std::move(fields[3].words)});
  }
  return found;
}

std::vector<Job> RedisJobs::of_other_versions(const std::string& version) {
  std::vector<Job> jobs;
  for (const RedisReply& id : run(scripts_.others, 0, {version}).items)
    if (auto job = find(id.words)) jobs.push_back(*std::move(job));
  return jobs;
}

JobLoad RedisJobs::load(TimeMs now) {
  const std::vector<RedisReply> found = run(scripts_.load, now, {}).items;
  JobLoad load;
  if (found.size() != 9 + load.jobs.size()) throw StorageError("the farm's load is none");
  load.parts_waiting = found[0].count, load.parts_leased = found[1].count;
  load.bytes = found[2].count, load.jobs_unfinished = found[7].count;
  if (const TimeMs oldest = found[6].count; oldest > 0)
    load.oldest_wait_s = static_cast<double>(std::max(now - oldest, TimeMs{0})) / 1000;
  for (std::size_t i = 0; i < load.jobs.size(); ++i) load.jobs[i] = found[9 + i].count;
  load.farm = FarmCounts{found[3].count, found[4].count, found[5].count, found[8].count};
  return load;
}

}  // namespace tia::server
