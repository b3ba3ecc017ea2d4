// The exact solver of balls: event driven, free flight in closed form, no spin, no friction.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "core/motion/motion.h"

namespace tia {

/// MovingBall: it is there in [enters, leaves) and has its centre and velocity when it enters.
/// Domain: radius, mass > 0, all finite but `leaves`; enters >= 0.
struct MovingBall {
  Vec3d center{}, velocity{};
  double radius = 1, mass = 1;
  double enters = 0, leaves = std::numeric_limits<double>::infinity();
};

// Fixed things are surfaces that balls meet from either side, hollow where they enclose something.
// Space/units: the scene's.

struct FixedPlane {
  Vec3d point{}, normal{0, 1, 0};  ///< of any length but 0
};
struct FixedSphere {
  Vec3d center{};
  double radius = 1;
};
/// A parallelepiped: corner + three edges. Domain: a volume other than 0.
struct FixedBox {
  Vec3d corner{};
  std::array<Vec3d, 3> edges{};
};
/// Closed by two discs. Domain: base != cap.
struct FixedCylinder {
  Vec3d base{}, cap{};
  double radius = 1;
};
/// Domain: base != cap, else it is a sphere.
struct FixedCapsule {
  Vec3d base{}, cap{};
  double radius = 1;
};
/// Triangles by their corners' numbers; one without an area is its edges.
struct FixedMesh {
  std::vector<Vec3d> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
using FixedShape =
    std::variant<FixedPlane, FixedSphere, FixedBox, FixedCylinder, FixedCapsule, FixedMesh>;

struct ExactWorld {
  Vec3d gravity{};
  double duration = 0;
  std::vector<MovingBall> balls;
  std::vector<FixedShape> fixed;
  /// Of a pair a < b, numbered as BodyContact's; in [0, 1]. None: 1.
  std::function<double(std::size_t a, std::size_t b)> restitution = {};
};

/// TooManyEvents: more than were allowed before the end, at that time.
class TooManyEvents : public std::exception {
 public:
  TooManyEvents(std::size_t most_events, double at);
  const char* what() const noexcept override { return text_.c_str(); }
  const std::size_t most;
  const double time;

 private:
  std::string text_;
};

/// BodiesOverlap: a ball begins, at that time, where another or a fixed thing already is.
class BodiesOverlap : public std::exception {
 public:
  BodiesOverlap(std::size_t first, std::size_t second, double at);
  const char* what() const noexcept override { return text_.c_str(); }
  const std::size_t a, b;  ///< a < b, numbered as BodyContact's
  const double time;

 private:
  std::string text_;
};

/// The motion of balls from 0 to `duration`, the same on every machine.
///
/// Contacts at one time (1e-12 s) are solved together, pair by pair in the order of (a, b), until
/// no pair approaches by more than 1e-12. A ball whose bounces come closer than 1e-6 s rests on
/// what carries it and slides along it: on faces exactly, along what is curved by parabolas that
/// are never farther than 1e-10 of the world's size from it. So does a contact in a heap that
/// bounces more often within 1e-3 s than a free ball's can before they rest (shakes.h), as soon as
/// its next bounce would come within 1e-3 s.
/// A contact that takes energy bounces up to 64 times at one time; then it rests. Bounces that are
/// weak beside others of their time, below 1e-2, are told, and are events, together.
/// Errors: TooManyEvents, BodiesOverlap, Stopped.
/// Source: Alder, Wainwright, "Studies in Molecular Dynamics I", J. Chem. Phys. 31 (1959);
/// Lubachevsky, "How to Simulate Billiards and Similar Systems", J. Comput. Phys. 94 (1991);
/// Bannerman, Strobl, Formella, Poeschel, "Stable algorithm for event detection in event-driven
/// particle dynamics", Comput. Part. Mech. 1 (2014).
Motion solve_exact(const ExactWorld& world, std::size_t most_events,
                   const std::stop_token& stop = {});

}  // namespace tia
