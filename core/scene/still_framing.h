// Where the eye of a still stands: so that all that is shown of a model just fills the picture.
#pragma once

#include <vector>

#include "core/math/transform.h"
#include "core/scene/camera.h"

namespace tia {

/// StillPoints: what a picture of a model shows: the corners of its triangles, and the centres of
/// the balls that stand for its points. Space/units: the scene's.
struct StillPoints {
  std::vector<Vec3d> corners, balls;
  double ball_radius = 0;

  bool empty() const { return corners.empty() && balls.empty(); }
};

/// StillBall: a ball around points: its centre is that of their box, its radius the largest
/// distance from there. It is not the smallest one.
struct StillBall {
  Vec3d center{};
  double radius = 0;
};
/// Returns: a ball of radius 1 where there is but one place, for lights need some size.
/// Domain: at least one point.
StillBall ball_around(const StillPoints& points);

/// The least height of all. Domain: at least one point.
double lowest_of(const StillPoints& points);

/// The direction from what is looked at to an eye or a light: azimuth 0 is the front, +z, and 90
/// is +x; elevation 90 is straight above, +y. Unit.
Vec3d orbit_direction(double azimuth_degrees, double elevation_degrees);
/// The axes of a camera there, also straight above and below.
Basis orbit_basis(double azimuth_degrees, double elevation_degrees);

/// StillFrame: how a still sees what it shows.
struct StillFrame {
  Basis axes;
  double fov_degrees = 30;  ///< vertical; 0: parallel rays
  double zoom = 1;          ///< how many times as large as what fills the picture
  double aspect = 1;        ///< the picture's width over its height
};

/// The camera of that frame by which the points touch a frame of 0.9 times the picture across or
/// along, and keep equal distances from the planes through both other sides of it. Zoom then
/// narrows the view about its centre.
///
/// In the camera's axes, z along the view, and with s the slope of the frame's side, the eye must
/// have x - s z <= A' = e_x - s e_z and -x - s z <= B' = -e_x - s e_z for all points. With A and B
/// the most of the left sides, both are equal at e_x = (A - B) / 2 and e_z = -(A + B) / (2 s).
/// Balls of radius r reach sqrt(1 + s^2) r further. The eye stays at least R / 1000 before all.
/// Domain: at least one point; fov_degrees 0 or 1 to 170, zoom 0.1 to 1000.
Camera framed(const StillPoints& points, const StillFrame& frame);

/// Cameras of these axes, which look at the middle of the box around the points and see it alike:
/// all from the least distance from which the points keep within that frame in every picture; of
/// parallel rays, all of the same height. The frame's own axes are of no account.
/// Domain: as framed's; at least one axes.
std::vector<Camera> framed_alike(const StillPoints& points, const std::vector<Basis>& axes,
                                 const StillFrame& frame);

}  // namespace tia
