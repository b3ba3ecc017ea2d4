// ExactSolver: one run of the exact solver, from event to event.
#pragma once

#include <cstdint>
#include <vector>

#include "core/motion/ball_grid.h"
#include "core/motion/contact_cluster.h"
#include "core/motion/event_queue.h"
#include "core/motion/exact.h"
#include "core/motion/fixed_patches.h"
#include "core/motion/shakes.h"
#include "core/motion/thinned.h"

namespace tia {

class ExactSolver {
 public:
  ExactSolver(const ExactWorld& world, std::size_t most_events, const std::stop_token& stop);
  Motion run();

 private:
  using Kind = MotionEvent::Kind;
  static constexpr std::size_t no_body = ClusterContact::no_body;
  struct State {
    Knot knot{};  ///< the last one
    bool there = false;
    std::uint32_t version = 0;
    double next_slide = Aabb::far;  ///< when it would be too far off a curve that it slides along
    std::vector<std::size_t> held;  ///< balls, and patches after them, that it rests on or carries
    Shakes shakes;                  ///< by the same numbers, of contacts whose a it is
  };

  // exact_solver.cpp: the run
  void schedule();
  void handle(const MotionEvent& event);
  bool is_true(const MotionEvent& event) const;
  void enter_all();
  void leave(std::size_t ball);
  void check_free(std::size_t ball) const;
  void count_events(std::size_t more);
  void record_energy(bool last);

  // exact_predictions.cpp: what will happen to a ball until it leaves its cell
  void predict(std::size_t ball);
  void predict_balls(std::size_t ball, const Flight& flight, double until);
  void predict_patches(std::size_t ball, const Flight& flight, double until);
  void predict_slide(std::size_t ball, const Flight& flight, double until);
  void push(Kind kind, std::size_t ball, std::size_t other, double after);
  Flight flight_of(std::size_t ball) const;
  GapTolerance tolerance_of(const Flight& flight) const;
  bool holds(std::size_t ball, std::size_t other) const;
  bool is_below_held(std::size_t ball, std::size_t patch) const;

  // exact_contacts.cpp: contacts at one time
  void solve(bool slides);
  void seed(std::size_t ball);
  void gather();
  void gather_around(std::size_t body);
  void add_pair(std::size_t ball, std::size_t other);
  void add_patch(std::size_t ball, std::size_t patch);
  bool is_forced(std::size_t ball, std::size_t other) const;
  void keep_energy(std::size_t body);
  void note_bounces(const ClusterContact& c, std::size_t other);
  void store();
  double slide_step(const ClusterContact& contact) const;
  double time_of_leaving(const ClusterContact& contact, double step) const;

  std::size_t ball_count() const { return world_.balls.size(); }

  const ExactWorld& world_;
  const std::size_t most_events_;
  const std::stop_token& stop_;
  FixedPatches patches_;
  double touch_;  ///< lengths that rounding may make
  BallGrid grid_;
  EventQueue queue_;
  std::vector<State> states_;
  double now_ = 0;
  std::size_t events_ = 0, handled_ = 0;

  ContactCluster cluster_;
  std::vector<std::size_t> body_of_;                         // by ball, in the cluster
  std::vector<std::pair<std::size_t, std::size_t>> forced_;  // contacts whose time has come

  Motion motion_;
  Thinned<BodyContact> contacts_;
  Thinned<BodyEnergy> energies_;
};

}  // namespace tia
