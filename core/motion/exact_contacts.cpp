#include <algorithm>
#include <cmath>

#include "core/math/powers.h"
#include "core/motion/exact_solver.h"

namespace tia {
void ExactSolver::seed(std::size_t ball) {
  if (body_of_[ball] != no_body || !states_[ball].there) return;
  const Knot& knot = states_[ball].knot;
  body_of_[ball] = cluster_.bodies.size();
  const MovingBall& own = world_.balls[ball];
  cluster_.bodies.push_back(
      {ball,
       {now_, center_at(knot, now_), velocity_at(knot, now_), knot.acceleration},
       1 / own.mass,
       own.radius});
}

bool ExactSolver::is_forced(std::size_t ball, std::size_t other) const {
  return std::find(forced_.begin(), forced_.end(), std::pair{ball, other}) != forced_.end();
}

// Two balls a < b that touch, or whose time has come, or of which one rests on the other.
void ExactSolver::add_pair(std::size_t ball, std::size_t other) {
  const std::size_t a = std::min(ball, other), b = std::max(ball, other);
  const Vec3d way = center_at(states_[a].knot, now_) - center_at(states_[b].knot, now_);
  const double distance = length(way);
  const double gap = distance - (world_.balls[a].radius + world_.balls[b].radius);
  const bool was_held = holds(a, b);
  if (gap > touch_ && !was_held && !is_forced(a, b)) return;
  if (body_of_[other] != no_body && body_of_[other] < body_of_[ball]) return;  // it is there
  seed(other);
  ClusterContact contact{a, b, 0, body_of_[a], body_of_[b], way * (1 / distance), gap};
  contact.bend_radius = distance;
  contact.was_held = was_held;
  contact.shakes = states_[a].shakes.contains(b, now_, was_held);
  if (world_.restitution) contact.restitution = world_.restitution(a, b);
  cluster_.contacts.push_back(contact);
}

void ExactSolver::add_patch(std::size_t ball, std::size_t patch) {
  const ContactPatch& shape = patches_.patch(patch);
  const Vec3d x = center_at(states_[ball].knot, now_);
  const double radius = world_.balls[ball].radius;
  const std::size_t other = ball_count() + patch;
  const bool was_held = holds(ball, other), forced = is_forced(ball, other);
  const Touch touch = touch_of(shape, x, radius, forced ? 2 * touch_ : touch_ / 4);
  if (!(was_held || forced ? touch.gap < Aabb::far : std::fabs(touch.gap) <= touch_)) return;
  const std::size_t b = ball_count() + patches_.owner(patch);
  ClusterContact contact{ball, b, patch, body_of_[ball], no_body, touch.normal, touch.gap};
  contact.bend_radius = bend_radius(shape, x, radius);
  contact.was_held = was_held;
  contact.forced = forced;
  contact.shakes = states_[ball].shakes.contains(other, now_, was_held);
  if (world_.restitution) contact.restitution = world_.restitution(ball, b);
  cluster_.contacts.push_back(contact);
}

void ExactSolver::gather_around(std::size_t body) {
  const std::size_t ball = cluster_.bodies[body].ball;
  grid_.for_each_near(ball, [&](std::size_t other) { add_pair(ball, other); });
  if (patches_.count() == 0) return;
  const Vec3d x = cluster_.bodies[body].now.center;
  const double reach = world_.balls[ball].radius + 1024 * touch_;
  const Vec3d r{reach, reach, reach};
  patches_.for_each_near({x - r, x + r}, [&](std::size_t patch) { add_patch(ball, patch); });
}

// All that touch the seeds, directly or by others.
void ExactSolver::gather() {
  for (std::size_t body = 0; body < cluster_.bodies.size(); ++body) gather_around(body);
  for (ClusterContact& c : cluster_.contacts) {
    if (c.body_b != no_body) continue;
    for (const ClusterContact& other : cluster_.contacts) {
      if (other.body_a != c.body_a || other.body_b != no_body) continue;
      const auto* plane = std::get_if<PlanePatch>(&patches_.patch(other.patch));
      if (plane == nullptr) continue;
      c.lies_below =
          c.lies_below || lies_below(patches_.patch(c.patch), *plane, other.normal, touch_);
    }
  }
}

void ExactSolver::solve(bool slides) {
  gather();
  cluster_.begin();
  const std::size_t left = most_events_ - events_;
  std::size_t rounds = 0;
  do {
    if (!cluster_.collide(left) || rounds++ > left) throw TooManyEvents(most_events_, now_);
  } while (cluster_.settle(patches_.all()));
  cluster_.close_gaps(1024 * touch_, touch_ / 64);
  if (slides && cluster_.impulses.empty())
    for (std::size_t body = 0; body < cluster_.bodies.size(); ++body) keep_energy(body);
  store();
}

// A ball that slides along a curve follows it in steps, whose errors would add up in its speed.
void ExactSolver::keep_energy(std::size_t body) {
  bool curved = false;
  for (const ClusterContact& c : cluster_.contacts) {
    if (!c.was_held || (c.body_a != body && c.body_b != body)) continue;
    if (c.body_b != no_body) return;
    curved = curved || c.bend_radius < Aabb::far;
  }
  if (!curved) return;
  Knot& now = cluster_.bodies[body].now;
  const Knot& last = states_[cluster_.bodies[body].ball].knot;
  const double square = dot(now.velocity, now.velocity);
  const double wanted =
      dot(last.velocity, last.velocity) + 2 * dot(world_.gravity, now.center - last.center);
  const double ratio = wanted / square;
  if (std::fabs(ratio - 1) < 1e-3) now.velocity = now.velocity * std::sqrt(ratio);
}

// For how long the acceleration may stay as it is along a curve of radius R: it turns with the
// normal at v / R, so that it changes by at most (|g| + 3 |a|) v / R a second, and by as much times
// a / v a second later; what that comes to in place is t^3 / 6 and t^4 / 24 of it.
double ExactSolver::slide_step(const ClusterContact& c) const {
  if (c.bend_radius == Aabb::far) return Aabb::far;
  Vec3d v = cluster_.bodies[c.body_a].now.velocity, a = cluster_.bodies[c.body_a].now.acceleration;
  if (c.body_b != no_body) {
    v = v - cluster_.bodies[c.body_b].now.velocity;
    a = a - cluster_.bodies[c.body_b].now.acceleration;
  }
  const double speed = length(v), size = length(a), most = length(world_.gravity) + 3 * size;
  const double room = 64 * touch_ * c.bend_radius;
  const double third = speed * most, fourth = size * most;
  const double by_third = third > 0 ? pow_of(6 * room / third, 1.0 / 3) : Aabb::far;
  const double by_fourth = fourth > 0 ? std::sqrt(std::sqrt(24 * room / fourth)) : Aabb::far;
  return time_of_leaving(c, std::min(by_third, by_fourth));
}

// Within a step, when a fixed curve no longer presses: n . g + v . H v, which is below 0 while it
// does, is taken for a line. Else the step itself.
double ExactSolver::time_of_leaving(const ClusterContact& c, double step) const {
  if (c.body_b != no_body || !(step < Aabb::far)) return step;
  const Knot& now = cluster_.bodies[c.body_a].now;
  const ContactPatch& patch = patches_.patch(c.patch);
  const Flight flight{now.center, now.velocity, now.acceleration};
  const auto press_at = [&](double t) {
    const Vec3d x = flight.position_at(t);
    const Vec3d n = touch_of(patch, x, world_.balls[c.a].radius, Aabb::far).normal;
    return -dot(n, world_.gravity) - bend_of(patch, x, flight.velocity_at(t));
  };
  const double first = press_at(0), last = press_at(step);
  if (!(first > 0 && last < 0)) return step;
  return std::max(step * (first / (first - last)) * (1 + 1e-9), step * 1e-4);
}

// With a restitution of 0 it rests, which is no shaking; some are needed, then.
void ExactSolver::note_bounces(const ClusterContact& c, std::size_t other) {
  const double left = c.bounces > 0 ? std::max(c.restitution, 0.05) : 1;
  states_[c.a].shakes.note(other, now_, left, c.shakes);
}

void ExactSolver::store() {
  for (const BodyContact& impulse : cluster_.impulses) contacts_.add(impulse);
  for (const ContactCluster::Body& body : cluster_.bodies) {
    State& state = states_[body.ball];
    const Knot& was = state.knot;
    state.held.clear();
    state.next_slide = Aabb::far;
    const bool same = body.now.acceleration == was.acceleration &&
                      body.now.velocity == velocity_at(was, now_) &&
                      body.now.center == center_at(was, now_);
    if (same) continue;
    auto& path = motion_.paths[body.ball];
    if (!path.empty() && path.back().time == now_) path.pop_back();
    path.push_back(body.now);
    state.knot = body.now;
  }
  for (const ClusterContact& c : cluster_.contacts) {
    const std::size_t other = c.body_b == no_body ? ball_count() + c.patch : c.b;
    note_bounces(c, other);
    if (!c.held) continue;
    const double next = now_ + slide_step(c);
    const auto hold = [&](std::size_t ball, std::size_t by) {
      states_[ball].held.push_back(by);
      states_[ball].next_slide = std::min(states_[ball].next_slide, next);
    };
    hold(c.a, other);
    if (c.body_b != no_body) hold(c.b, c.a);
  }
  count_events(std::max<std::size_t>(cluster_.told, 1));
  record_energy(false);
  for (const ContactCluster::Body& body : cluster_.bodies) body_of_[body.ball] = no_body;
  for (const ContactCluster::Body& body : cluster_.bodies) predict(body.ball);
  cluster_.clear();
  forced_.clear();
}

}  // namespace tia
