// The search for a field's roots along one line, cell by cell.
#pragma once

#include "core/shapes/formula/field_form.h"

namespace tia::detail {

/// FieldLine: a field along a line.
class FieldLine {
 public:
  FieldLine(const Program& field, const Line& line) : field_(field), line_(line) {}

  double value(double t) const;
  /// Over eight stretches of the line at once. Space/units: stretches ascending in t.
  Dual<Interval<Octet>, 1> over(const Interval<Octet>& t, Definedness<Octet>& where) const;
  Interval<Octet> at(const Octet& t, Definedness<Octet>& where) const;
  const Program& field() const { return field_; }
  const Line& line() const { return line_; }
  const Vec3d& direction() const { return line_.direction; }
  int cost() const { return field_.cost; }

 private:
  const Program& field_;
  const Line& line_;
};

class FieldSearch {
 public:
  /// Space/units: `reach` is how far from the line's origin the search goes. With `brackets_alone`
  /// roots are told of that are bracketed and not yet found.
  FieldSearch(const Program& field, const Line& line, double reach, FieldListener& listener,
              bool brackets_alone);

  /// Searches the line's stretch within a cell, but for what has been searched before; cells come
  /// in the order of the line. Space/units: `start` is the line's origin less the cells' middle.
  /// Returns: whether to go on.
  bool visit(const FieldCell& cell, const Vec3d& start, double in, double out);
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
  bool tell(const FieldEvent& event);
  bool settle(double t, bool inside);
  bool inside_before(double t);
  bool inside_at(double t);

  FieldLine along_;
  FieldListener& listener_;
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
