#include "server/jobs/redis_fields.h"

#include <algorithm>
#include <charconv>

#include "server/contract/problem.h"

namespace tia::server {
namespace {

using Fields = std::map<std::string_view, std::string_view>;

std::int64_t number_in_field(std::string_view text) {
  std::int64_t number = 0;
  const char* const end = text.data() + text.size();
  if (const auto [stop, error] = std::from_chars(text.data(), end, number);
      error != std::errc{} || stop != end)
    throw StorageError("the farm keeps a number that is none: " + std::string(text.substr(0, 40)));
  return number;
}

template <class Name>
Name name_in_field(std::string_view text) {
  const auto& names = Names<Name>::names;
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end())
    throw StorageError("the farm keeps a state that is none: " + std::string(text.substr(0, 40)));
  return static_cast<Name>(found - names.begin());
}

// One field after the other, in and out.
struct FieldWriter {
  std::vector<std::string>& to;
  void operator()(const char* name, const std::string& text) const {
    to.emplace_back(name);
    to.push_back(text);
  }
  void operator()(const char* name, std::int64_t number) const {
    (*this)(name, std::to_string(number));
  }
  void operator()(const char* name, int number) const { (*this)(name, std::to_string(number)); }
  void operator()(const char* name, bool is) const { (*this)(name, std::to_string(is ? 1 : 0)); }
  void operator()(const char* name, Priority priority) const {
    (*this)(name, std::string(name_of(priority)));
  }
};

struct FieldReader {
  const Fields& from;
  std::string_view at(const char* name) const {
    const auto found = from.find(name);
    return found == from.end() ? std::string_view() : found->second;
  }
  std::int64_t number(const char* name) const {
    return at(name).empty() ? 0 : number_in_field(at(name));
  }
  void operator()(const char* name, std::string& text) const { text = at(name); }
  void operator()(const char* name, std::int64_t& to) const { to = number(name); }
  void operator()(const char* name, int& to) const { to = static_cast<int>(number(name)); }
  void operator()(const char* name, bool& is) const { is = number(name) != 0; }
  template <class Name>
  void operator()(const char* name, Name& to) const {
    to = name_in_field<Name>(at(name));
  }
};

template <class Job, class Visitor>
void plan_fields(Job& job, const Visitor& visit) {
  visit("version", job.version), visit("request", job.request), visit("plan", job.plan);
  visit("parts", job.parts), visit("joins", job.joins);
}

template <class Job, class Visitor>
void new_fields(Job& job, const Visitor& visit) {
  visit("id", job.id), visit("owner", job.owner), visit("key", job.key);
  visit("digest", job.digest), visit("kind", job.kind), visit("name", job.name);
  visit("priority", job.priority), visit("max_rays", job.max_rays);
  visit("result_bytes", job.result_bytes), visit("deadline", job.deadline);
  visit("needs", job.needs);
  plan_fields(job, visit);
}

}  // namespace

std::vector<std::string> redis_fields(const NewJob& job) {
  std::vector<std::string> fields;
  new_fields(job, FieldWriter{fields});
  return fields;
}

std::vector<std::string> redis_plan_fields(const NewJob& job) {
  std::vector<std::string> fields;
  plan_fields(job, FieldWriter{fields});
  return fields;
}

Job job_of(const RedisReply& reply) {
  Fields fields;
  for (std::size_t i = 0; i + 1 < reply.items.size(); i += 2)
    fields[reply.items[i].words] = reply.items[i + 1].words;
  const FieldReader read{fields};
  Job job;
  new_fields(job, read);
  read("state", job.state);
  read("created", job.created), read("started", job.started);
  read("finished", job.finished), read("expires", job.expires);
  read("waiting", job.waiting), read("leased", job.leased);
  read("done", job.done), read("dead", job.dead);
  RayCounts& rays = job.rays;
  read("primary", rays.primary), read("shadow", rays.shadow);
  read("reflection", rays.reflection), read("refraction", rays.refraction);
  read("cut", rays.cut);
  read("problem", job.problem), read("etag", job.etag), read("type", job.type);
  read("bytes", job.bytes), read("gone", job.is_gone), read("events", job.events);
  return job;
}

PartRow part_of(int n, const RedisReply& row) {
  PartRow part{.n = n};
  if (row.kind != RedisReply::text) return part;
  std::string_view left = row.words;
  const auto next = [&] {
    const std::string_view field = left.substr(0, left.find('\x1f'));
    left.remove_prefix(std::min(left.size(), field.size() + 1));
    return field;
  };
  const auto number = [&] {
    const std::string_view field = next();
    return field.empty() ? 0 : number_in_field(field);
  };
  part.state = name_in_field<PartState>(next());
  part.tries = static_cast<int>(number());
  part.worker = next(), part.etag = next(), part.place = next();
  part.ms = number(), part.rays = number(), part.bytes = number();
  part.type = next();
  return part;
}

}  // namespace tia::server
