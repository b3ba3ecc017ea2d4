// The search for the roots of a function along one line, cell by cell.
#pragma once

#include "core/shapes/formula/isosurface_form.h"

namespace tia::detail {

/// IsosurfaceLine: a function along a line.
class IsosurfaceLine {
 public:
  IsosurfaceLine(const Program& function, const Line& line) : function_(function), line_(line) {}

  double value(double t) const;
  /// Over eight stretches of the line at once. Space/units: stretches ascending in t.
  Dual<Interval<Octet>, 1> over(const Interval<Octet>& t, Definedness<Octet>& where) const;
  Interval<Octet> at(const Octet& t, Definedness<Octet>& where) const;
  const Program& function() const { return function_; }
  const Line& line() const { return line_; }
  const Vec3d& direction() const { return line_.direction; }
  int cost() const { return function_.cost; }

 private:
  const Program& function_;
  const Line& line_;
};

class IsosurfaceSearch {
 public:
  /// Space/units: `reach` is how far from the line's origin the search goes. With `brackets_alone`
  /// roots are told of that are bracketed and not yet found.
  IsosurfaceSearch(const Program& function, const Line& line, double reach,
                   IsosurfaceListener& listener, bool brackets_alone);

  /// Searches the part of the line in a cell, less what has been searched already; cells come in
  /// the order of the line. Space/units: `start` is the line's origin less the cells' middle.
  /// Returns: whether to go on.
  bool visit(const IsosurfaceCell& cell, const Vec3d& start, double in, double out);
  /// In tests of a sphere, roughly.
  std::int64_t work() const;

 private:
  struct Piece;
  struct Eight;
  class Pieces;

  bool cross_once(double from, double to, bool inside_from, bool inside_to, double guess,
                  std::string_view how);
  bool part(double from, double to);
  void part(const Piece& piece, Pieces& waiting);
  bool finish(const Piece& piece);
  bool finish_least(const Piece& piece);
  bool vanishes(const Piece& piece);
  bool tell(const IsosurfaceEvent& event);
  bool settle(double t, bool inside);
  bool inside_before(double t);
  bool inside_at(double t);

  IsosurfaceLine along_;
  IsosurfaceListener& listener_;
  bool brackets_alone_;
  double tolerance_;  ///< of roots
  double least_;      ///< a stretch that is parted no further
  double searched_ = -Aabb::far;
  double known_t_ = Aabb::far;
  bool known_inside_ = false;  ///< at known_t_
  bool inside_ = false, told_ = false;
  double touched_to_ = -Aabb::far;
  int values_ = 0, eights_ = 0;
};

}  // namespace tia::detail
