#include "server/jobs/drawing.h"

#include <algorithm>
#include <chrono>

#include "core/input/json.h"
#include "server/jobs/windows.h"
#include "server/operation/memory_account.h"
#include "server/requests/draw.h"
#include "server/requests/recipe.h"
#include "server/requests/with_memory.h"

namespace tia::server {
namespace {

std::int64_t rays_left(const Job& job) {
  return std::max(job.max_rays - job.rays.all(), std::int64_t{1});
}

// The numbers of that member of JSON's; none where it is not there.
std::vector<double> numbers_in(const std::string& place, const char* name) {
  const Value told = parse_json("{" + place + "}");
  std::vector<double> numbers;
  if (const Value* list = find(*told.as<Value::Object>(), name))
    for (const Value& each : *list->as<Value::Array>()) numbers.push_back(*each.as<double>());
  return numbers;
}

PartResult result_of(const Picture& picture, std::string etag, const std::string& place) {
  PartResult result;
  result.etag = std::move(etag);
  result.type = picture.media_type;
  result.rays = picture.rays;
  result.place = place + counted_text(picture.rays) + reached_text(picture);
  return result;
}

/// PartDrawing: what is drawn for a job, as heavy work that has the least share of the threads.
class PartDrawing {
 public:
  PartDrawing(const Job& job, const JobParts& parts, const Workplace& at,
              const std::stop_token& stop)
      : job_(job), parts_(parts), at_(at), stop_(stop) {
    flow_.client = requester_.number();
    flow_.is_long = true;
    flow_.is_background = true;
  }

  PartResult part(int n) {
    const PictureRequest asked = parts_.part(n);
    Plan plan = plan_for(asked);
    plan.takes_codes = parts_.are_pieces();
    const std::string etag = etag_of(plan.recipe);
    if (!plan.takes_codes)
      if (const auto kept = at_.pictures.find(etag)) {
        PartResult result = of(*kept->picture, etag, n);
        result.is_found = true;
        return result;
      }
    settle_memory();
    const auto picture = std::make_shared<Picture>(drawn(plan));
    at_.metrics.count(picture->rays, picture->timing);
    at_.access.charge(key_of(job_), picture->rays.all());
    if (plan.takes_codes) {
      PartResult result = result_of(*picture, etag, parts_.place(n));
      result.bytes = std::move(picture->bytes);
      return result;
    }
    at_.pictures.add(etag, picture);
    return of(*picture, etag, n);
  }

  // Its rays have been counted with the parts.
  PartResult whole() {
    const PictureRequest asked = parts_.whole();
    const Plan plan = plan_for(asked);
    const std::string etag = etag_of(plan.recipe);
    reserve_memory(2 * job_.result_bytes, "this picture", stop_);
    ReachedOfWindows reached;
    const auto picture = std::make_shared<Picture>(parts_.join(
        plan, [&](int n) { return piece(n, reached); }, workers(plan)));
    picture->rays = job_.rays;
    picture->reached = reached.reached();
    picture->tells_reached = picture->tells_noise = picture->reached.has_value();
    PartResult result = of(*picture, etag, job_.parts);
    result.rays = {};
    at_.pictures.add(etag, picture);
    return result;
  }

 private:
  Plan plan_for(const PictureRequest& asked) {
    Plan plan = plan_of(asked, at_.host.context, requester_);
    plan.options.max_rays = rays_left(job_);
    plan.options.flow = &flow_;
    return plan;
  }
  Workers workers(const Plan& plan) {
    return at_.host.context.pool.workers(plan.options.threads, stop_, &flow_);
  }
  Picture drawn(const Plan& plan) {
    const auto attempt = [&] {
      Picture picture = draw(plan, at_.host.context, stop_);
      at_.host.costs.learn(plan.cost_key, plan.rays(), picture.trace_seconds, true);
      return picture;
    };
    return with_memory_for(attempt, stop_);
  }
  PartResult of(const Picture& picture, const std::string& etag, int n) const {
    const std::string place = n < job_.parts ? parts_.place(n) : "\"frame\":0";
    PartResult result = result_of(picture, etag, place);
    result.bytes = picture.bytes;
    return result;
  }
  std::string piece(int n, ReachedOfWindows& reached) {
    const auto row = at_.store.part(job_.id, n);
    auto bytes = at_.store.result(job_.id, n);
    if (!row || !bytes) throw std::runtime_error("a piece is not there");
    if (const auto of = reached_in(row->place)) {
      const PictureRequest asked = parts_.part(n);
      reached.add(*of, asked.window());
    }
    return std::move(*bytes);
  }

  const Job& job_;
  const JobParts& parts_;
  const Workplace& at_;
  const std::stop_token& stop_;
  const Requester requester_{jobs_share, stop_};
  Flow flow_{};
};

}  // namespace

PartResult draw_part(const Job& job, const JobParts& parts, int n, const Workplace& at,
                     const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  PartDrawing drawing(job, parts, at, stop);
  PartResult result = n < job.parts ? drawing.part(n) : drawing.whole();
  result.ms = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start).count();
  return result;
}

std::string counted_text(const RayCounts& rays) {
  const auto number = [](std::int64_t n) { return Value(static_cast<double>(n)); };
  return ",\"counted\":" +
         to_json(Value::Array{number(rays.primary), number(rays.shadow), number(rays.reflection),
                              number(rays.refraction), number(rays.cut)});
}

std::string reached_text(const Picture& picture) {
  if (!picture.tells_reached || !picture.reached) return "";
  const Reached& is = *picture.reached;
  return ",\"reached\":" + to_json(Value::Array{is.least, is.most, is.mean, is.noise, is.samples});
}

std::optional<RayCounts> rays_in(const std::string& place) {
  const std::vector<double> told = numbers_in(place, "counted");
  if (told.empty()) return std::nullopt;
  const auto number = [&](std::size_t i) { return static_cast<std::int64_t>(told[i]); };
  return RayCounts{number(0), number(1), number(2), number(3), number(4)};
}

std::optional<Reached> reached_in(const std::string& place) {
  const std::vector<double> told = numbers_in(place, "reached");
  if (told.empty()) return std::nullopt;
  return Reached{static_cast<int>(told[0]), static_cast<int>(told[1]), told[2], told[3],
                 static_cast<int>(told[4])};
}

}  // namespace tia::server
