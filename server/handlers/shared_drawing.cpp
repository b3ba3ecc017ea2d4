// Pictures drawn once for all who ask for them: by turns, within what memory allows.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>

#include "core/render/kept_rounds.h"
#include "server/handlers/handlers.h"
#include "server/operation/timing.h"
#include "server/requests/draw.h"
#include "server/requests/with_memory.h"

namespace tia::server {
namespace {

// What threads are foreseen to take.
Cost cost_of(const Plan& plan, bool is_watched, Service& service) {
  Cost cost = service.costs.of(plan.cost_key, plan.rays());
  if (plan.asked->budget_ms)
    cost.seconds = std::min(cost.seconds, *plan.asked->budget_ms * 1e-3 * plan.options.threads);
  if (is_watched) cost.seconds = std::max(cost.seconds, 2 * Cost::most_light_seconds);
  return cost;
}

/// WhenShown: when a drawing is shown: at most every 100 ms, and for no more than a twentieth of
/// its time, but for its first pictures.
class WhenShown {
 public:
  bool is_due() {
    const auto now = Clock::now();
    if (now < next_ || spent_ > between + (now - start_) / 20) return false;
    begun_ = now;
    return true;
  }
  void has_shown() {
    const auto now = Clock::now();
    spent_ += now - begun_;
    next_ = now + between;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds between{100};
  const Clock::time_point start_ = Clock::now();
  Clock::time_point begun_{}, next_{};
  Clock::duration spent_{};
};

// Has it go on from where another one was left, and, if it is left itself, another one from there.
void use_rounds(Plan& plan, Service& service) {
  if (plan.rounds_name.empty()) return;
  plan.options.from = service.pictures.rounds_of(plan.rounds_name);
  plan.options.leave = [&](const SharedRounds& rounds) {
    service.pictures.keep_rounds(plan.rounds_name, rounds);
  };
}

// Shows what a drawing comes to, and keeps it.
Onlooker onlooker_of(Showing& showing, Service& service) {
  const auto when = std::make_shared<WhenShown>();
  return {[when] { return when->is_due(); },
          [when, &showing, &service](SeenPicture seen) {
            service.pictures.add(seen.picture->etag, seen.picture);
            service.metrics.count_shown();
            showing.show(std::move(seen));
            when->has_shown();
          }};
}

Picture drawn(Plan& plan, const Requester& requester, SharedFlow& shared, Showing& showing,
              const std::stop_token& stop, Service& service) {
  const bool is_watched = showing.is_watched();
  const double rays = plan.rays();
  service.access.check_rays(requester.key, rays);
  Stopwatch watch;
  // It begins once admission has given a ticket, and gives it back at its end.
  auto ticket = service.admission.enter(cost_of(plan, is_watched, service), requester.client, stop,
                                        &shared.place);
  Flow flow{Requester{ticket.client(), stop}.number()};
  const double queue_ms = watch.lap_ms();
  plan.options.flow = &flow;
  std::atomic<std::int64_t> traced = 0;  // with what it goes on from
  plan.options.spent = [&](std::int64_t rays_done, std::int64_t tests) {
    traced = rays_done;
    ticket.has_done(rays_done, tests);
  };
  use_rounds(plan, service);
  // It may be parked then, and must not keep a light one's place, however few its rays are.
  flow.became_long = [&] { ticket.turn_heavy(); };
  const SharedFlow::Going going(shared, flow);
  MemoryClaim* const claim = MemoryClaim::current();
  const Onlooker onlooker = onlooker_of(showing, service);
  const auto attempt = [&] {
    Picture picture =
        draw(plan, service.rendering, stop, showing.is_watched() ? &onlooker : nullptr);
    if (picture.rays_before > 0) service.metrics.count_resumed();
    if (!plan.asked->has_budget() && picture.rays_before == 0)
      service.costs.learn(plan.cost_key, rays, picture.trace_seconds, true);
    picture.timing.queue = queue_ms;
    picture.timing.wait = claim != nullptr ? claim->waited_ms() : 0;
    service.metrics.count(picture.rays, picture.timing);
    service.access.charge(requester.key, picture.rays.all() - picture.rays_before);
    return picture;
  };
  const auto charge_for_what_is_left = [&] {
    const std::int64_t before = plan.options.from ? plan.options.from->rays().all() : 0;
    service.access.charge(requester.key, traced - before);
  };
  try {
    return with_memory_for(attempt, stop);
  } catch (const Stopped&) {
    service.costs.learn(plan.cost_key, rays, static_cast<double>(flow.attained) * 1e-9, false);
    charge_for_what_is_left();
    throw;
  } catch (const InputError&) {  // it has passed a limit
    charge_for_what_is_left();
    throw;
  }
}

}  // namespace

PictureStore::Wish waiting_wish(const Requester& requester, const Showing::See& see,
                                Service& service) {
  PictureStore::Wish wish;
  wish.stop = requester.stop;
  wish.client = requester.client;
  wish.see = see;
  wish.wait = [client = requester.client, &service] {
    return std::make_shared<Admission::QueuePlace>(service.admission.wait_for_others(client));
  };
  return wish;
}

PictureStore::Found drawn_once(const std::string& etag, const Requester& requester,
                               Service& service, const Showing::See& see, const DrawShared& draw) {
  const auto shared = std::make_shared<SharedFlow>(service.rendering.pool);
  const auto showing = std::make_shared<Showing>();
  std::optional<Showing::Seat> seat;
  if (see) seat.emplace(*showing, see);
  PictureStore::Wish wish = waiting_wish(requester, see, service);
  wish.showing = showing;
  wish.draw = [&](const std::stop_token& given_up) { return draw(*shared, *showing, given_up); };
  wish.joined_by = [shared](const std::string& client) { shared->also_for(client); };
  return service.pictures.get(etag, wish);
}

PictureStore::Found picture_of(Plan& plan, const std::string& etag, const Requester& requester,
                               Service& service, const Showing::See& see) {
  return drawn_once(etag, requester, service, see,
                    [&](SharedFlow& flow, Showing& showing, const std::stop_token& stop) {
                      return drawn(plan, requester, flow, showing, stop, service);
                    });
}

}  // namespace tia::server
