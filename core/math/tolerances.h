// The tolerances that follow from the rounding of float, each with its derivation, for they depend
// on one another. Those of a search in double, which follow from its own arithmetic, and the limits
// of what a scene may say are explained where they are used.
#pragma once

namespace tia::tolerance {

/// The relative error of one rounding to float. All that follow are compared with it.
inline constexpr float rounding = 0x1p-24F;

// ---- boxes ------------------------------------------------------------------------------------

/// By which share the t of a box's faces is moved outwards. In (face - origin) * inverse there are
/// three roundings, the inverse's included, and a hit's t_max has one: together 4 * 2^-24, a
/// quarter of this.
inline constexpr float box_t = 0x1p-20F;

/// By which share of its coordinate a box's face is moved outwards before it is rounded to float. A
/// ray may run in the plane of the face, and its origin is rounded by 2^-24 of the coordinate: a
/// quarter of this. At least, for a face at 0, `box_face_least`.
inline constexpr double box_face = 0x1p-22, box_face_least = 1e-20;

/// The uncertainty of a ray's origin in a group's space, as a share of its largest coordinate. It
/// is computed in double and rounded to float once, by 2^-24: a quarter of this.
inline constexpr float group_origin = 0x1p-22F;

/// As box_face, of the instances in a grid, as a share of the grid's largest coordinate: twice
/// that, because a box there is the sum of two numbers, an instance's offset and the box of one.
inline constexpr double grid_box = 0x1p-21;

/// By which share t_max is enlarged for a primitive that is searched in double. A hit behind t_max
/// may be rounded, by 2^-24, to t_max itself, and then the order in the scene decides: 16 times
/// that.
inline constexpr double search_t = 1e-6;

// ---- rays that start on surfaces --------------------------------------------------------------

/// How far from a surface rays start, as a share of max(t, the point's largest coordinate). The
/// thesis takes 1e-4, and its camera sees its balls from a distance of 20: 1e-4 / 20.
///
/// It has to exceed the error of the point origin + t * direction. In each component there are
/// three roundings, of t, of the product and of the sum, the first two by 2^-24 t, the last by
/// 2^-24 of the coordinate: by length at most (2 + sqrt 3) 2^-24 = 2.2e-7, a twentieth of this.
inline constexpr float ray_offset = 5e-6F;

/// How far a textured point may be off its surface, as a share of the same. It is 2^-24 t where t
/// was found in double, and up to mesh_error / mesh_large = 3e-6 t on a triangle.
inline constexpr double texture_point = 4e-6;

// ---- meshes, in units of the mesh (MeshIndex::unit) --------------------------------------------

/// How far off a triangle's plane the point is that the test in float finds. Measured: 2e7 random
/// rays and triangles, origins up to 2.4 units away on each axis: at most 1.24e-6; 94 % are below
/// 2^-22.
inline constexpr float mesh_error = 1.25e-6F;

/// How much larger boxes are than the triangles in them: three times mesh_error.
inline constexpr float mesh_box = 0x1p-18F;

/// A mesh is large for a ray whose distances are below this many of its units. From there on the
/// offset of new rays, 0.4 * ray_offset = 2e-6, exceeds mesh_error; below, the surface would shadow
/// itself, and hits are settled in double, by the plane of their triangle.
inline constexpr float mesh_large = 0.4F;

/// Up to which distance hits are settled. A ray that leaves a surface at the sine s to it meets it
/// again, by mesh_error, no farther than mesh_error / s: this covers s down to 0.02, and for the 94
/// % down to 0.004.
inline constexpr float mesh_near = 0x1p-14F;
/// Up to which share of mesh_near behind the origin hits are settled: one that float sees there may
/// be ahead in truth. mesh_near * mesh_behind is 2^-19, more than mesh_error.
inline constexpr float mesh_behind = 0x1p-5F;
/// Where a settled distance is beyond this, the triangle is seen nearly edge on, and its plane
/// tells nothing of where it is: 16 times mesh_near.
inline constexpr double mesh_near_plane = 0x1p-10;
/// How far a settled distance may be from the one that float has found; else the triangle is seen
/// nearly edge on. 200 times mesh_error: sines down to 0.005.
inline constexpr double mesh_settled = 0x1p-12;

// ---- trees over formulas -----------------------------------------------------------------------

/// How much larger than what they contain the boxes of isosurface cells and of patches are, as a
/// share of the whole surface's size. Lines are tried on them in float (OffsetBvh): a face, the
/// origin, their difference and the product with the inverse are rounded by 2^-24 of the size each,
/// at either end of the stretch in a box. That makes 2^-21, a quarter of this.
inline constexpr double cell_box = 0x1p-19;

}  // namespace tia::tolerance
