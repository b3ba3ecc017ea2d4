// ContactCluster: balls that touch each other or fixed things at one time, and what becomes of
// their velocities and accelerations there.
#pragma once

#include <cstddef>
#include <vector>

#include "core/motion/contact_forces.h"
#include "core/motion/contact_patch.h"
#include "core/motion/motion.h"

namespace tia {

/// What rounding may leave of a velocity of approach: 1e-12, and more of great velocities.
double approach_slack(const Vec3d& velocity);

/// A contact: of a body with another one or with a patch.
struct ClusterContact {
  static constexpr std::size_t no_body = static_cast<std::size_t>(-1);
  std::size_t a = 0, b = 0;                  ///< numbered as BodyContact's, a < b
  std::size_t patch = 0;                     ///< where there is no second body
  std::size_t body_a = 0, body_b = no_body;  ///< in the cluster
  Vec3d normal{};                            ///< from b to a
  double gap = 0, restitution = 1;
  double bend_radius = Aabb::far;  ///< of what a's centre meets
  bool forced = false;             ///< its time has come, whatever its gap is to rounding
  bool lies_below = false;  ///< an edge or a corner in a plane that the ball touches, too: it is
                            ///< met only where that is left
  bool was_held = false;    ///< rested on until now
  bool shakes = false;      ///< see Shakes
  // Found by the cluster:
  double bend = 0;   ///< see bend_of
  double force = 0;  ///< a resting contact's, mass times acceleration
  bool resting = false, stops = false, held = false;
  bool presses = false;        ///< so far as one knows, before forces are found
  int bounces = 0;             ///< at this time, where they take energy
  std::size_t told = no_body;  ///< the last one of its impulses
};

class ContactCluster {
 public:
  struct Body {
    std::size_t ball = 0;
    Knot now{};
    double inverse_mass = 1, radius = 1;
  };
  std::vector<Body> bodies;
  std::vector<ClusterContact> contacts;
  std::vector<BodyContact> impulses;  ///< in the order in which they were given
  std::size_t told = 0;               ///< of them, that are not weak

  explicit ContactCluster(const Vec3d& gravity);
  void clear();
  /// Sorts the contacts, and takes from those that were held what has grown of approach or
  /// departure by rounding and along curves.
  void begin();
  /// Gives impulses until no contact approaches. Returns: whether that took at most `most`. What is
  /// as slow as what rests does not bounce but in the first call.
  bool collide(std::size_t most);
  /// Decides which contacts rest: those whose next bounce would come within 1e-6 s; takes away
  /// their last velocity and finds the accelerations that they leave. Returns: whether a contact
  /// approaches now, so that there is to be another collision.
  bool settle(const std::vector<ContactPatch>& patches);
  /// Shifts bodies onto what holds them, by what rounding and curves have made, at most `most`,
  /// until `least` is left.
  void close_gaps(double most, double least);

 private:
  double gap_rate(const ClusterContact& c) const;
  double acceleration(const ClusterContact& c) const;
  double slack(const ClusterContact& c) const;
  double inverse_mass(const ClusterContact& c) const;
  void push(const ClusterContact& c, double impulse);
  void press(ClusterContact& c, double force);
  void tell(ClusterContact& c, double impulse, bool weak);
  void find_forces();
  void start_forces();
  void refine_forces();
  bool press_in_turn(int most_rounds);
  std::vector<std::size_t> resting() const;
  ContactMatrix matrix_of(const std::vector<std::size_t>& chosen) const;
  bool drop_bouncing();
  void stop_resting();
  bool stop_more();
  double slowest_bounce(const ClusterContact& c) const;
  bool find_bends(const std::vector<ContactPatch>& patches);

  Vec3d gravity_;
  double weight_;
  bool settled_ = false;
};

}  // namespace tia
