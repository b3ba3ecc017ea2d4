#include "server/jobs/kinds.h"

#include <array>
#include <stdexcept>

#include "core/input/json.h"

namespace tia::server {

Picture JobParts::join(const Plan&, const Piece&, const Workers&) const {
  throw std::logic_error("parts that are no pieces");
}
PictureRequest JobParts::whole() const { throw std::logic_error("parts that are no pieces"); }

std::span<const JobKind> job_kinds() {
  static const std::array all{render_job, batch_job, turntable_job};
  return all;
}

const JobKind& job_kind(const std::string& name) {
  std::vector<std::string_view> names;
  for (const JobKind& kind : job_kinds()) {
    if (kind.name == name) return kind;
    names.push_back(kind.name);
  }
  throw InputError({FaultKind::unknown_name, "/kind", excerpt(Value(name)), listed(names)});
}

JobRequest asked_again(const Job& job) {
  Value kept = parse_json(job.request, {.values = 10'000'000, .option = ""});
  kept.as<Value::Object>()->emplace_back("kind", job.kind);
  return read_job_request(std::move(kept), {});
}

PictureRequest picture_at(const Value& request, const std::string& place, const JobHost& host,
                          const Requester& requester) {
  return at_place(place, [&] {
    auto asked = read_described<PictureRequest>(request, {}, requester.stop);
    const auto refuse = [](const char* pointer, const Value& got) {
      throw InputError({FaultKind::conflict, pointer, got,
                        "no budget: a job's pictures are known before they are drawn"});
    };
    if (asked.budget_ms) refuse("/budget_ms", *asked.budget_ms);
    if (asked.max_rays) refuse("/max_rays", static_cast<double>(*asked.max_rays));
    static_cast<void>(host);
    return asked;
  });
}

}  // namespace tia::server
