#include "core/motion/contact_cluster.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tia {
namespace {

// So often a contact that takes energy bounces at one time; what is left of its approach then is
// taken away at once.
constexpr int most_bounces = 64;

// What share of the fastest approach at one time is told by itself, and how often of a contact that
// takes energy.
constexpr double least_told = 1e-2;
constexpr int most_told = 4;

}  // namespace

double approach_slack(const Vec3d& v) {
  return 1e-12 + 4e-15 * (std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z));
}

ContactCluster::ContactCluster(const Vec3d& gravity)
    : gravity_(gravity), weight_(length(gravity)) {}

void ContactCluster::clear() {
  bodies.clear();
  contacts.clear();
  impulses.clear();
  settled_ = false;
  told = 0;
}

// The velocity at which the gap grows.
double ContactCluster::gap_rate(const ClusterContact& c) const {
  Vec3d v = bodies[c.body_a].now.velocity;
  if (c.body_b != c.no_body) v = v - bodies[c.body_b].now.velocity;
  return dot(c.normal, v);
}
double ContactCluster::acceleration(const ClusterContact& c) const {
  Vec3d a = bodies[c.body_a].now.acceleration;
  if (c.body_b != c.no_body) a = a - bodies[c.body_b].now.acceleration;
  return dot(c.normal, a) + c.bend;
}
double ContactCluster::slack(const ClusterContact& c) const {
  const double own = approach_slack(bodies[c.body_a].now.velocity);
  return c.body_b == c.no_body ? own : own + approach_slack(bodies[c.body_b].now.velocity);
}
double ContactCluster::inverse_mass(const ClusterContact& c) const {
  const double own = bodies[c.body_a].inverse_mass;
  return c.body_b == c.no_body ? own : own + bodies[c.body_b].inverse_mass;
}
void ContactCluster::push(const ClusterContact& c, double impulse) {
  Body& a = bodies[c.body_a];
  a.now.velocity = a.now.velocity + c.normal * (impulse * a.inverse_mass);
  if (c.body_b == c.no_body) return;
  Body& b = bodies[c.body_b];
  b.now.velocity = b.now.velocity - c.normal * (impulse * b.inverse_mass);
}
void ContactCluster::press(ClusterContact& c, double force) {
  c.force += force;
  Body& a = bodies[c.body_a];
  a.now.acceleration = a.now.acceleration + c.normal * (force * a.inverse_mass);
  if (c.body_b == c.no_body) return;
  Body& b = bodies[c.body_b];
  b.now.acceleration = b.now.acceleration - c.normal * (force * b.inverse_mass);
}

void ContactCluster::begin() {
  std::sort(contacts.begin(), contacts.end(), [](const auto& x, const auto& y) {
    return std::tie(x.a, x.b, x.patch) < std::tie(y.a, y.b, y.patch);
  });
  for (ClusterContact& c : contacts) c.stops = c.presses = c.was_held;
  stop_resting();
}

bool ContactCluster::collide(std::size_t most) {
  double strongest = 0;
  std::size_t passes = 0;
  for (bool again = true; again;) {
    if (++passes > most) return false;
    again = false;
    for (ClusterContact& c : contacts) {
      const double rate = gap_rate(c);
      if (!(rate < -slack(c)) || (c.lies_below && !(c.forced && !settled_))) continue;
      const bool weak = (settled_ || c.shakes) && -rate <= slowest_bounce(c);
      const bool bounces = c.bounces < most_bounces && !weak;
      const double impulse = -(bounces ? 1 + c.restitution : 1) * rate / inverse_mass(c);
      push(c, impulse);
      again = true;
      if (!bounces) continue;
      c.bounces += c.restitution < 1 ? 1 : 0;
      strongest = std::max(strongest, -rate);
      tell(c, impulse, -rate < least_told * strongest || c.bounces > most_told);
      if (impulses.size() > most) return false;
    }
  }
  return true;
}

// What is weak is added to the last one of its contact.
void ContactCluster::tell(ClusterContact& c, double impulse, bool weak) {
  told += weak ? 0 : 1;
  if (weak && c.told != ClusterContact::no_body) {
    impulses[c.told].impulse += impulse;
    return;
  }
  c.told = impulses.size();
  const Body& a = bodies[c.body_a];
  impulses.push_back({a.now.time, c.a, c.b, a.now.center - c.normal * a.radius, c.normal, impulse});
}

void ContactCluster::close_gaps(double most, double least) {
  constexpr int most_rounds = 64;
  std::vector<Vec3d> shifts(bodies.size());
  bool moves = true;
  for (int round = 0; round < most_rounds && moves; ++round) {
    moves = false;
    for (const ClusterContact& c : contacts) {
      if (!c.held || c.force == 0 || std::fabs(c.gap) > most) continue;
      Vec3d shifted = shifts[c.body_a];
      if (c.body_b != c.no_body) shifted = shifted - shifts[c.body_b];
      const double gap = c.gap + dot(c.normal, shifted), way = -gap / inverse_mass(c);
      moves = moves || std::fabs(gap) > least;
      shifts[c.body_a] = shifts[c.body_a] + c.normal * (way * bodies[c.body_a].inverse_mass);
      if (c.body_b == c.no_body) continue;
      shifts[c.body_b] = shifts[c.body_b] - c.normal * (way * bodies[c.body_b].inverse_mass);
    }
  }
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies[i].now.center = bodies[i].now.center + shifts[i];
}

}  // namespace tia
