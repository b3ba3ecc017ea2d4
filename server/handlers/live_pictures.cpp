#include "server/handlers/live_pictures.h"

#include <condition_variable>
#include <mutex>

#include "core/film/jpeg.h"
#include "server/handlers/bodies.h"
#include "server/handlers/mixed_parts.h"
#include "server/http/error.h"
#include "server/requests/draw.h"
#include "server/requests/with_memory.h"

namespace tia::server {
namespace {

// Proxies wait half a minute and more.
constexpr std::chrono::seconds most_silence{10};
constexpr std::chrono::milliseconds look{500};

void sleep_until(Clock::time_point then, const std::stop_token& stop) {
  std::mutex mutex;
  std::condition_variable_any never;
  std::unique_lock lock(mutex);
  never.wait_until(lock, stop, then, [] { return false; });
  end_if_asked(stop);
}

}  // namespace

std::string LivePictures::drawn(Plan& plan) {
  settle_memory();
  const double rays = plan.rays();
  service_.access.check_rays(requester_.key, rays);
  auto ticket = service_.admission.enter(service_.costs.of(plan.cost_key, rays), requester_.client,
                                         requester_.stop);
  Flow flow{requester_.number()};
  flow.became_long = [&] { ticket.turn_heavy(); };
  plan.options.flow = &flow;
  plan.options.spent = [&](std::int64_t so_far, std::int64_t tests) {
    ticket.has_done(so_far, tests);
  };
  const auto attempt = [&] {
    Picture picture = tia::server::draw(plan, service_.rendering, requester_.stop);
    service_.costs.learn(plan.cost_key, rays, picture.trace_seconds, true);
    service_.metrics.count(picture.rays, picture.timing);
    service_.access.charge(requester_.key, picture.rays.all());
    return picture;
  };
  const Picture picture = with_memory_for(attempt, requester_.stop);
  std::string jpeg;
  const auto encode = [&] {
    Image8 image(plan.window.width(), plan.window.height());
    image.rgb.assign(picture.bytes.begin(), picture.bytes.end());
    jpeg = encode_jpeg(image);
  };
  service_.rendering.pool.alone(encode, requester_.stop, &flow);
  settle_memory();
  return jpeg;
}

std::optional<std::string> LivePictures::draw(Plan& plan) {
  try {
    return drawn(plan);
  } catch (const HttpError& error) {
    if (last_.empty() || error.type() != "busy") throw;
  }
  wait_until(Clock::now() + look / 5);
  return std::nullopt;
}

void LivePictures::show(const std::string& jpeg, const Headers& fields, bool is_last) {
  if (last_.empty()) send_(mixed_parts::begin());
  last_ = mixed_parts::part("image/jpeg", fields, jpeg, is_last);
  send_.latest(last_);
  sent_ = Clock::now();
  send_.await_taken();
}

void LivePictures::look_round() {
  if (service_.draining)
    throw HttpError("draining", "the server goes down; ask again", {{"Retry-After", "1"}});
  if (!last_.empty() && Clock::now() - sent_ > most_silence) {
    send_.latest(last_);
    sent_ = Clock::now();
    send_.await_taken();
  }
}

void LivePictures::wait_until(Clock::time_point then) {
  for (;; sleep_until(Clock::now() + look, requester_.stop)) {
    look_round();
    if (Clock::now() + look >= then) return sleep_until(then, requester_.stop);
  }
}

Response live_response(ShowsLive show, const Request& request, Service& service) {
  const Requester requester = requester_of(request);
  const auto seat = std::make_shared<LiveStreams::Seat>(service.live.take(requester.client));
  Response response{.content_type = std::string(mixed_parts::media_type), .body = ""};
  response.headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}};
  response.problem_part = mixed_parts::problem;
  response.parts_deadline = std::chrono::milliseconds(service.config.film_deadline_ms);
  response.parts = [show = std::move(show), seat, requester, &service](const SendPart& send) {
    MemoryClaim claim(service.memory, requester.client);
    const ClaimScope scope(&claim);
    LivePictures pictures(service, requester, send);
    show(pictures);
  };
  return response;
}

}  // namespace tia::server
