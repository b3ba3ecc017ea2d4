#include <algorithm>
#include <cmath>

#include "core/motion/exact_solver.h"

namespace tia {
namespace {

// Around all places of a flight until a time.
Aabb swept_box(const Flight& flight, double until, double reach) {
  Aabb box = around(around(Aabb{}, flight.position), flight.position_at(until));
  const auto turn = [&](double v, double a) {
    const double t = -v / a;  // infinite or NaN where it never turns
    if (0 < t && t < until) box = around(box, flight.position_at(t));
  };
  turn(flight.velocity.x, flight.acceleration.x);
  turn(flight.velocity.y, flight.acceleration.y);
  turn(flight.velocity.z, flight.acceleration.z);
  const Vec3d r{reach, reach, reach};
  return {box.min - r, box.max + r};
}

}  // namespace

Flight ExactSolver::flight_of(std::size_t ball) const {
  const Knot& knot = states_[ball].knot;
  return {center_at(knot, now_), velocity_at(knot, now_), knot.acceleration};
}

GapTolerance ExactSolver::tolerance_of(const Flight& flight) const {
  return {touch_, approach_slack(flight.velocity)};
}

bool ExactSolver::holds(std::size_t ball, std::size_t other) const {
  const auto& held = states_[ball].held;
  return std::find(held.begin(), held.end(), other) != held.end();
}

// A ball that slides along a plane meets no edge and no corner of it before it leaves it.
bool ExactSolver::is_below_held(std::size_t ball, std::size_t patch) const {
  const Vec3d x = center_at(states_[ball].knot, now_);
  for (const std::size_t other : states_[ball].held) {
    if (other < ball_count()) continue;
    const auto* plane = std::get_if<PlanePatch>(&patches_.patch(other - ball_count()));
    if (plane == nullptr) continue;
    const double side = dot(plane->normal, x - plane->point);
    if (lies_below(patches_.patch(patch), *plane, side < 0 ? -plane->normal : plane->normal,
                   touch_))
      return true;
  }
  return false;
}

void ExactSolver::push(Kind kind, std::size_t ball, std::size_t other, double after) {
  MotionEvent event{now_ + after,
                    kind,
                    static_cast<std::uint32_t>(ball),
                    static_cast<std::uint32_t>(other),
                    states_[ball].version,
                    0};
  if (kind == Kind::meets_ball) event.other_version = states_[other].version;
  queue_.push(event);
}

void ExactSolver::predict(std::size_t ball) {
  State& state = states_[ball];
  if (!state.there) return;
  ++state.version;
  const Flight flight = flight_of(ball);
  const double end = std::min(world_.duration, world_.balls[ball].leaves) - now_;
  const BallGrid::Crossing crossing = grid_.next_crossing(ball, flight);
  const double until = std::max(std::min(end, crossing.time), 0.0);
  predict_balls(ball, flight, until);
  predict_patches(ball, flight, until);
  predict_slide(ball, flight, until);
  if (crossing.time <= end)
    push(Kind::crosses, ball, static_cast<std::size_t>(crossing.face), crossing.time);
}

void ExactSolver::predict_balls(std::size_t ball, const Flight& flight, double until) {
  const double radius = world_.balls[ball].radius, slack = approach_slack(flight.velocity);
  const bool rests = !states_[ball].held.empty();
  grid_.for_each_near(ball, [&](std::size_t other) {
    if (rests && holds(ball, other)) return;
    const Flight theirs = flight_of(other);
    const Flight between{flight.position - theirs.position, flight.velocity - theirs.velocity,
                         flight.acceleration - theirs.acceleration};
    if (between.acceleration == Vec3d{} && dot(between.position, between.velocity) >= 0) return;
    const double last = std::min(until, world_.balls[other].leaves - now_);
    const double t = pair_time(between, radius + world_.balls[other].radius, last,
                               {touch_, slack + approach_slack(theirs.velocity)});
    if (t <= until) push(Kind::meets_ball, std::min(ball, other), std::max(ball, other), t);
  });
}

void ExactSolver::predict_patches(std::size_t ball, const Flight& flight, double until) {
  if (patches_.count() == 0) return;
  const double radius = world_.balls[ball].radius;
  const GapTolerance tolerance = tolerance_of(flight);
  const Aabb box = swept_box(flight, until, radius + 4 * touch_);
  patches_.for_each_near(box, [&](std::size_t patch) {
    if (holds(ball, ball_count() + patch) || is_below_held(ball, patch)) return;
    const double t = contact_time(patches_.patch(patch), flight, radius, until, tolerance);
    if (t <= until) push(Kind::meets_patch, ball, patch, t);
  });
}

// When it is to be looked at again while it slides: it leaves the patch, or its curve.
void ExactSolver::predict_slide(std::size_t ball, const Flight& flight, double until) {
  const State& state = states_[ball];
  double first = state.next_slide - now_;
  for (const std::size_t other : state.held) {
    if (other < ball_count()) continue;
    const ContactPatch& patch = patches_.patch(other - ball_count());
    first = std::min(first, end_of_patch(patch, flight, until, touch_));
  }
  if (first <= until) push(Kind::slides, ball, 0, std::max(first, 0.0));
}

}  // namespace tia
