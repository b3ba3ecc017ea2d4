// Of a ContactCluster what rests, and how hard it presses.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/motion/contact_cluster.h"

namespace tia {
namespace {

// Two bounces within this rest, see Shakes. Space/units: seconds.
double shortest_bounce(const ClusterContact& c) { return c.shakes ? 1e-3 : 1e-6; }

// Which share of the weight an acceleration may be off by.
constexpr double held_share = 1e-9, force_share = 1e-15;

// Up to so many contacts are solved at once.
constexpr std::size_t most_dense = 512;

}  // namespace

// Nothing is pressed by more than some times its weight, but in piles that are high.
double ContactCluster::slowest_bounce(const ClusterContact& c) const {
  return shortest_bounce(c) * ((c.shakes ? 1 : 16) * weight_ + 2 * std::fabs(c.bend));
}

// Returns: whether one has changed.
bool ContactCluster::find_bends(const std::vector<ContactPatch>& patches) {
  bool changed = false;
  for (ClusterContact& c : contacts) {
    const double before = c.bend;
    const Knot& a = bodies[c.body_a].now;
    if (c.body_b == c.no_body) {
      c.bend = bend_of(patches[c.patch], a.center, a.velocity);
    } else {
      const Knot& b = bodies[c.body_b].now;
      c.bend = bend_of(SpherePatch{b.center, 0}, a.center, a.velocity - b.velocity);
    }
    const double most = held_share / 16 * (weight_ + std::fabs(c.bend));
    changed = changed || std::fabs(c.bend - before) > most;
  }
  return changed;
}

// Contacts press, each in turn as hard as it must not to approach, until all agree. Returns:
// whether they do. Source: Baraff, "Fast Contact Force Computation for Nonpenetrating Rigid
// Bodies", SIGGRAPH 1994, for what holds: no force pulls, and where one presses nothing
// accelerates; by the projected Gauss-Seidel method: Cottle, Pang, Stone, The Linear
// Complementarity Problem (1992), 5.2.
bool ContactCluster::press_in_turn(int most_rounds) {
  for (int round = 0; round < most_rounds; ++round) {
    bool settled = true;
    for (ClusterContact& c : contacts) {
      if (!c.resting) continue;
      const double change = acceleration(c), mass = 1 / inverse_mass(c);
      const double force = std::max(-change * mass, -c.force);
      if (force == 0) continue;
      press(c, force);
      settled = settled && std::fabs(force) <= force_share * (weight_ + std::fabs(c.bend)) * mass;
    }
    if (settled) return true;
  }
  return false;
}

// Where directions are nearly the same that takes too long, and few contacts are solved at once.
void ContactCluster::find_forces() {
  const std::vector<std::size_t> all = resting();
  std::vector<std::size_t> guess;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (contacts[all[i]].presses) guess.push_back(i);
  start_forces();
  const bool dense = all.size() <= most_dense;
  if (press_in_turn(dense ? 4 : 2000) || !dense) return;
  start_forces();
  std::vector<double> rates;
  double most = weight_;
  for (const std::size_t i : all) {
    rates.push_back(acceleration(contacts[i]));
    most = std::max(most, std::fabs(contacts[i].bend));
  }
  const std::vector<double> forces =
      nonnegative_forces(matrix_of(all), rates, most * held_share / 16, std::move(guess));
  for (std::size_t i = 0; i < all.size(); ++i) {
    contacts[all[i]].presses = forces[i] > 0;
    if (forces[i] > 0) press(contacts[all[i]], forces[i]);
  }
  refine_forces();
}

void ContactCluster::start_forces() {
  for (Body& body : bodies) body.now.acceleration = gravity_;
  for (ClusterContact& c : contacts) c.force = 0;
}

// What the matrix's stiffening has left, twice.
void ContactCluster::refine_forces() {
  std::vector<std::size_t> pressing;
  for (const std::size_t i : resting())
    if (contacts[i].force > 0) pressing.push_back(i);
  const ContactMatrix matrix = matrix_of(pressing);
  std::vector<std::size_t> chosen(pressing.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  for (int round = 0; round < 2; ++round) {
    std::vector<double> rates;
    rates.reserve(chosen.size());
    for (const std::size_t i : pressing) rates.push_back(acceleration(contacts[i]));
    const std::vector<double> more = solve_chosen(matrix, rates, chosen);
    for (std::size_t i = 0; i < pressing.size(); ++i)
      press(contacts[pressing[i]], std::max(more[i], -contacts[pressing[i]].force));
  }
}

std::vector<std::size_t> ContactCluster::resting() const {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i].resting) all.push_back(i);
  return all;
}

// How a contact's gap is parted by a unit of force at another one.
ContactMatrix ContactCluster::matrix_of(const std::vector<std::size_t>& chosen) const {
  ContactMatrix matrix(chosen.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    const ClusterContact& own = contacts[chosen[i]];
    for (std::size_t j = 0; j < chosen.size(); ++j) {
      const ClusterContact& other = contacts[chosen[j]];
      const auto share = [&](std::size_t mine, std::size_t theirs) {
        return mine == theirs && mine != own.no_body ? bodies[mine].inverse_mass : 0;
      };
      matrix.at(i, j) = dot(own.normal, other.normal) *
                        (share(own.body_a, other.body_a) - share(own.body_a, other.body_b) -
                         share(own.body_b, other.body_a) + share(own.body_b, other.body_b));
    }
  }
  return matrix;
}

// Those that come back later than rests do.
bool ContactCluster::drop_bouncing() {
  bool dropped = false;
  for (ClusterContact& c : contacts) {
    if (!c.resting || c.force == 0) continue;
    if (2 * gap_rate(c) < shortest_bounce(c) * c.force * inverse_mass(c)) continue;
    if (std::fabs(gap_rate(c)) <= slack(c)) continue;
    c.resting = false;
    dropped = true;
  }
  return dropped;
}

// Takes away what is left of the velocities of those that rest, at once where they are few.
void ContactCluster::stop_resting() {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (contacts[i].stops) all.push_back(i);
  const auto in_turn = [&](int rounds) {
    for (bool moves = true; moves && rounds > 0; --rounds) {
      moves = false;
      for (const std::size_t i : all) {
        const double rate = gap_rate(contacts[i]);
        moves = moves || std::fabs(rate) > slack(contacts[i]) / 2;
        push(contacts[i], -rate / inverse_mass(contacts[i]));
      }
    }
    return rounds > 0;
  };
  if (in_turn(all.size() > most_dense ? 2000 : 16) || all.size() > most_dense) return;
  const ContactMatrix matrix = matrix_of(all);
  std::vector<std::size_t> chosen(all.size());
  std::iota(chosen.begin(), chosen.end(), std::size_t{0});
  for (int round = 0; round < 2; ++round) {
    std::vector<double> rates;
    rates.reserve(chosen.size());
    for (const std::size_t i : all) rates.push_back(gap_rate(contacts[i]));
    const std::vector<double> pushes = solve_chosen(matrix, rates, chosen);
    for (std::size_t i = 0; i < all.size(); ++i) push(contacts[all[i]], pushes[i]);
  }
}

// Those that thereby approach, as slowly as what rests, are stopped with them: one after another
// they would take too long where their directions are nearly the same.
bool ContactCluster::stop_more() {
  bool more = false;
  for (ClusterContact& c : contacts) {
    const double rate = gap_rate(c);
    if (c.stops || c.lies_below || rate >= -slack(c) || rate < -slowest_bounce(c)) continue;
    c.stops = true;
    more = true;
  }
  return more;
}

bool ContactCluster::settle(const std::vector<ContactPatch>& patches) {
  find_bends(patches);
  for (ClusterContact& c : contacts)
    c.resting = !c.lies_below && gap_rate(c) <= std::max(slowest_bounce(c), slack(c));
  do find_forces();
  while (drop_bouncing());
  for (ClusterContact& c : contacts) c.stops = c.resting && c.force > 0;
  do stop_resting();
  while (stop_more());
  if (find_bends(patches)) find_forces();  // along curves less speed needs less force
  settled_ = true;
  bool approaches = false;
  for (ClusterContact& c : contacts) {
    const double most = held_share * (weight_ + std::fabs(c.bend));
    approaches = approaches || (!c.lies_below && gap_rate(c) < -slack(c));
    c.held = c.resting && std::fabs(gap_rate(c)) <= slack(c) && std::fabs(acceleration(c)) <= most;
  }
  for (Body& body : bodies)
    if (length(body.now.acceleration) <= 1e-14 * weight_) body.now.acceleration = {};
  return approaches;
}

}  // namespace tia
