// Jobs of one picture, drawn in windows of about a second's work: the bytes, the tag and the rays
// are those of POST /render.
#include <algorithm>
#include <cmath>

#include "core/input/json.h"
#include "server/jobs/kinds.h"
#include "server/jobs/windows.h"
#include "server/requests/recipe.h"

namespace tia::server {
namespace {

constexpr double window_seconds = 1;

// The side of windows; 0: the picture is one part. A multiple of the tiles that are traced.
int window_side(const Plan& plan, const JobHost& host) {
  const int longest = std::max(plan.window.width(), plan.window.height());
  if (!can_be_cut(plan)) return 0;
  if (host.window_px > 0) return host.window_px < longest ? host.window_px : 0;
  const double seconds =
      host.costs.of(plan.cost_key, plan.rays()).seconds / host.context.pool.threads();
  const double pixels = static_cast<double>(plan.window.width()) * plan.window.height();
  const double side = std::sqrt(pixels * std::min(window_seconds / seconds, 1.0));
  constexpr int tile = FilmTile::size;
  const int whole = std::max(static_cast<int>(side) / tile * tile, tile);
  return whole < longest ? whole : 0;
}

// The recipe's request, which names nothing that may be forgotten; of large objects it does not
// tell enough.
Value::Object kept_request(const Value& asked, const Plan& plan) {
  if (told_scene_of(plan).objects.bytes > most_told_bytes) return {{"request", asked}};
  Value recipe = parse_json(plan.recipe, {.values = 10'000'000, .option = ""});
  std::erase_if(*recipe.as<Value::Object>(), [](auto& each) { return each.first != "request"; });
  return std::move(*recipe.as<Value::Object>());
}

JobPlan plan_render(const JobRequest& asked, const JobHost& host, const Requester& requester) {
  refuse_member(asked.requests, "/requests", "request, which is one: the kind is render");
  refuse_member(asked.grid, "/grid", "the kind batch, which has one");
  refuse_member(asked.views, "/views", "the kind turntable, which has them");
  const Value& request = needed(asked.request, "/request", "what POST /render takes");
  const PictureRequest picture = picture_at(request, "/request", host, requester);
  return at_place("/request", [&] {
    const Plan plan = plan_of(picture, host.context, requester);
    const int side = window_side(plan, host);
    const Windows windows{plan.window, side};
    const std::int64_t pixels = std::int64_t{plan.window.width()} * plan.window.height();
    JobPlan made;
    made.parts = side > 0 ? windows.count() : 1;
    made.joins = side > 0;
    made.request = to_json(kept_request(request, plan));
    made.plan =
        to_json(Value::Array{plan.window.x0, plan.window.y0, plan.window.x1, plan.window.y1, side});
    made.rays = plan.sure_rays();
    made.result_bytes = side > 0 ? pixels * static_cast<std::int64_t>(piece_pixel_bytes(plan)) : 0;
    return made;
  });
}

/// WindowsOfPicture: its parts.
class WindowsOfPicture : public JobParts {
 public:
  WindowsOfPicture(PictureRequest asked, const Value& plan) : asked_(std::move(asked)) {
    const auto& numbers = *plan.as<Value::Array>();
    const auto number = [&](std::size_t i) { return static_cast<int>(*numbers[i].as<double>()); };
    windows_ = {{number(0), number(1), number(2), number(3)}, number(4)};
  }
  bool are_pieces() const override { return windows_.side > 0; }
  PictureRequest whole() const override { return asked_; }
  PictureRequest part(int n) const override {
    PictureRequest one = asked_;
    if (!are_pieces()) return one;
    const Window window = windows_.window(n);
    one.crop = {window.x0, window.y0, window.x1, window.y1};
    return one;
  }
  std::string place(int n) const override {
    const Window at = are_pieces() ? windows_.window(n) : windows_.whole;
    return "\"window\":" + to_json(Value::Array{at.x0, at.y0, at.x1, at.y1});
  }
  Picture join(const Plan& whole, const Piece& piece, const Workers& workers) const override {
    Mosaic mosaic(whole);
    for (int n = 0; n < windows_.count(); ++n) {
      workers.end_if_asked();
      mosaic.put(windows_.window(n), piece(n));
    }
    Picture picture;
    picture.bytes = std::move(mosaic).file(workers);
    picture.media_type = media_type_of(whole.format);
    return picture;
  }

 private:
  const PictureRequest asked_;
  Windows windows_{};
};

std::unique_ptr<JobParts> open_render(const Job& job, const JobHost& host,
                                      const Requester& requester) {
  const JobRequest asked = asked_again(job);
  return std::make_unique<WindowsOfPicture>(picture_at(*asked.request, "/request", host, requester),
                                            parse_json(job.plan));
}

}  // namespace

const JobKind render_job{"render", plan_render, open_render};

}  // namespace tia::server
