#include "core/motion/exact_solver.h"

#include <algorithm>
#include <cmath>

#include "core/parallel/stopped.h"

namespace tia {
namespace {

// How much of the world's size rounding may make, over many operations.
constexpr double touch_share = 0x1p-40;

// All places that are known before anything moves.
Aabb first_box(const ExactWorld& world, const FixedPatches& patches) {
  Aabb box = patches.bounds();
  for (const MovingBall& ball : world.balls) {
    const Vec3d r{ball.radius, ball.radius, ball.radius};
    box = around(around(box, ball.center - r), ball.center + r);
  }
  return box.empty() ? Aabb{{0, 0, 0}, {1, 1, 1}} : box;
}
double size_of(const Aabb& box) {
  const Vec3d far = upper(box.max, -box.min);
  return std::max({far.x, far.y, far.z, -box.max.x, -box.max.y, -box.max.z, box.size().x});
}
double greatest_diameter(const ExactWorld& world) {
  double most = 0;
  for (const MovingBall& ball : world.balls) most = std::max(most, 2 * ball.radius);
  return most;
}
BallGrid grid_of(const ExactWorld& world, const FixedPatches& patches) {
  constexpr std::size_t most_cells = 1 << 20;
  const std::size_t cells = std::min(most_cells, 2 * world.balls.size() + patches.count() / 2);
  return {first_box(world, patches), 1.001 * greatest_diameter(world) + 1e-300,
          std::max<std::size_t>(cells, 1), world.balls.size()};
}
// Each energy is a sum over all balls.
std::size_t most_energies(std::size_t balls) {
  constexpr std::size_t most_terms = 20'000'000;
  return std::clamp<std::size_t>(most_terms / std::max<std::size_t>(balls, 1), 1000,
                                 Motion::most_records);
}

}  // namespace

ExactSolver::ExactSolver(const ExactWorld& world, std::size_t most_events,
                         const std::stop_token& stop)
    : world_(world),
      most_events_(most_events),
      stop_(stop),
      patches_(world.fixed),
      touch_(touch_share * size_of(first_box(world, patches_))),
      grid_(grid_of(world, patches_)),
      states_(world.balls.size()),
      cluster_(world.gravity),
      body_of_(world.balls.size(), no_body),
      contacts_(Motion::most_records),
      energies_(most_energies(world.balls.size())) {
  motion_.paths.resize(world.balls.size());
}

Motion ExactSolver::run() {
  schedule();
  while (!queue_.empty() && queue_.top().time <= world_.duration) {
    const MotionEvent event = queue_.top();
    queue_.pop();
    if (++handled_ % 256 == 0) {
      end_if_asked(stop_);
      if (queue_.size() > 64 * ball_count() + 4096)
        queue_.keep([&](const MotionEvent& each) { return is_true(each); });
    }
    if (!is_true(event)) continue;
    now_ = event.time;
    handle(event);
  }
  now_ = world_.duration;
  record_energy(true);
  motion_.contacts = std::move(contacts_).take();
  motion_.energy = std::move(energies_).take();
  motion_.events = events_;
  return std::move(motion_);
}

void ExactSolver::schedule() {
  for (std::size_t i = 0; i < ball_count(); ++i) {
    const MovingBall& ball = world_.balls[i];
    if (ball.enters > world_.duration || ball.enters >= ball.leaves) continue;
    const auto number = static_cast<std::uint32_t>(i);
    queue_.push({ball.enters, Kind::enters, number});
    if (ball.leaves <= world_.duration) queue_.push({ball.leaves, Kind::leaves, number});
  }
}

bool ExactSolver::is_true(const MotionEvent& event) const {
  if (event.kind == Kind::enters) return true;
  const State& state = states_[event.ball];
  if (event.kind == Kind::leaves) return true;
  return state.there && state.version == event.version &&
         (event.kind != Kind::meets_ball || states_[event.other].version == event.other_version);
}

void ExactSolver::handle(const MotionEvent& event) {
  switch (event.kind) {
    case Kind::enters: queue_.push(event); return enter_all();
    case Kind::leaves: return leave(event.ball);
    case Kind::crosses:
      grid_.cross(event.ball, static_cast<int>(event.other));
      return predict(event.ball);
    case Kind::slides: seed(event.ball); return solve(true);
    case Kind::meets_ball:
      forced_.emplace_back(event.ball, event.other);
      seed(event.ball);
      seed(event.other);
      return solve(false);
    case Kind::meets_patch:
      forced_.emplace_back(event.ball, ball_count() + event.other);
      seed(event.ball);
      return solve(false);
  }
}

// All that enter now, before any of them meets another. The energy before that is told, too: what
// comes or goes makes a step of it.
void ExactSolver::enter_all() {
  if (now_ > 0) record_energy(false);
  while (!queue_.empty() && queue_.top().kind == Kind::enters && queue_.top().time == now_) {
    const std::size_t i = queue_.top().ball;
    queue_.pop();
    const MovingBall& ball = world_.balls[i];
    State& state = states_[i];
    state.knot = {now_, ball.center, ball.velocity, world_.gravity};
    state.there = true;
    grid_.enter(i, ball.center);
    check_free(i);
    motion_.paths[i].push_back(state.knot);
    seed(i);
  }
  solve(false);
}

void ExactSolver::check_free(std::size_t ball) const {
  const double deepest = 1024 * touch_;
  const MovingBall& own = world_.balls[ball];
  grid_.for_each_near(ball, [&](std::size_t other) {
    const double apart = length(center_at(states_[other].knot, now_) - own.center);
    if (apart - own.radius - world_.balls[other].radius < -deepest)
      throw BodiesOverlap(std::min(ball, other), std::max(ball, other), now_);
  });
  const Vec3d r{own.radius, own.radius, own.radius};
  patches_.for_each_near({own.center - r, own.center + r}, [&](std::size_t patch) {
    if (touch_of(patches_.patch(patch), own.center, own.radius, 0).gap < -deepest)
      throw BodiesOverlap(ball, ball_count() + patches_.owner(patch), now_);
  });
}

// What rested on it is looked at again.
void ExactSolver::leave(std::size_t ball) {
  State& state = states_[ball];
  if (!state.there) return;
  record_energy(false);
  state.there = false;
  ++state.version;
  grid_.leave(ball);
  for (const std::size_t other : state.held)
    if (other < ball_count()) seed(other);
  state.held.clear();
  if (cluster_.bodies.empty()) record_energy(false);
  else solve(false);
}

void ExactSolver::count_events(std::size_t more) {
  events_ += more;
  if (events_ > most_events_) throw TooManyEvents(most_events_, now_);
}

void ExactSolver::record_energy(bool last) {
  if (!last && !energies_.keeps_next()) return energies_.skip();
  BodyEnergy sum{now_, 0, 0};
  for (std::size_t i = 0; i < ball_count(); ++i) {
    if (!states_[i].there) continue;
    const Vec3d v = velocity_at(states_[i].knot, now_);
    sum.kinetic += world_.balls[i].mass * dot(v, v) / 2;
    sum.potential -= world_.balls[i].mass * dot(world_.gravity, center_at(states_[i].knot, now_));
  }
  energies_.add(sum);
}

Motion solve_exact(const ExactWorld& world, std::size_t most_events, const std::stop_token& stop) {
  return ExactSolver(world, most_events, stop).run();
}

TooManyEvents::TooManyEvents(std::size_t most_events, double at)
    : most(most_events),
      time{at},
      text_("more than " + std::to_string(most_events) + " events by the time " +
            std::to_string(at) + " s") {}

BodiesOverlap::BodiesOverlap(std::size_t first, std::size_t second, double at)
    : a(first),
      b(second),
      time{at},
      text_("bodies " + std::to_string(first) + " and " + std::to_string(second) +
            " overlap at the time " + std::to_string(at) + " s") {}

}  // namespace tia
