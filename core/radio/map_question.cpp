#include "core/radio/map_question.h"

#include <cmath>

namespace tia {
namespace {

void check_senders(const RadioMapQuestion& q, const Place& at, Faults& faults) {
  if (q.tx.empty() && q.transmitters.empty())
    faults.add({FaultKind::missing, at.at("tx").pointer(), std::nullopt,
                "tx, where a transmitter is, as x,y,z; or transmitters"});
  if (!q.tx.empty() && !q.transmitters.empty())
    faults.add({FaultKind::conflict, at.at("tx").pointer(), excerpt(write_value(q.tx)),
                "tx or transmitters"});
  if (q.tx.size() > RadioQuestion::most_antennas)
    faults.add({FaultKind::limit, at.at("tx").pointer(), Value(std::to_string(q.tx.size())),
                "at most " + std::to_string(RadioQuestion::most_antennas)});
}

// Of the words for a plane either all or none, and none of those for the plan.
void check_plane(const RadioMapQuestion& q, const Place& at, Faults& faults) {
  const bool any = q.origin || q.u || q.v;
  const auto part = [&](const char* name, const auto& is) {
    if (any && !is)
      faults.add({FaultKind::missing, at.at(name).pointer(), std::nullopt,
                  "origin, u and v together: the corner of a rectangle and its sides"});
  };
  part("origin", q.origin), part("u", q.u), part("v", q.v);
  const auto other = [&](const char* name, const auto& is) {
    if (any && is)
      faults.add({FaultKind::conflict, at.at(name).pointer(), write_value(is),
                  "area and height, or origin, u and v"});
  };
  other("area", q.area), other("height", q.height);
  if (!q.origin || !q.u || !q.v) return;
  const double across = length(*q.u), down = length(*q.v);
  if (!(across > 0))
    faults.add({FaultKind::out_of_range, at.at("u").pointer(), write_value(q.u), "not 0,0,0"});
  if (!(down > 0) || std::fabs(dot(*q.u, *q.v)) > 1e-6 * across * down)
    faults.add({FaultKind::out_of_range, at.at("v").pointer(), write_value(q.v),
                "not 0,0,0, and at right angles to u"});
}

// How many cells cover a length, which may be a little more than a multiple of them.
double count_of(double size, double cell) { return std::max(1.0, std::ceil(size / cell - 1e-9)); }

}  // namespace

void RadioMapQuestion::check(const Place& at, Faults& faults) const {
  RadioQuestion::check(at, faults);
  check_senders(*this, at, faults);
  check_plane(*this, at, faults);
  if (area && !((*area)[0] < (*area)[2] && (*area)[1] < (*area)[3]))
    faults.add({FaultKind::out_of_range, at.at("area").pointer(), write_value(area),
                "x0,z0,x1,z1 with x0 < x1 and z0 < z1"});
}

std::vector<Antenna> RadioMapQuestion::senders() const {
  if (tx.empty()) return transmitters;
  std::vector<Antenna> all;
  for (const Vec3d& position : tx) all.push_back({.position = position});
  return all;
}

std::string RadioMapQuestion::pointer_to(std::size_t sender) const {
  const Place all{};
  if (!tx.empty()) {
    const Place list = all.at("tx");
    return list.at(sender).pointer();
  }
  const Place list = all.at("transmitters"), one = list.at(sender);
  return one.at("position").pointer();
}

MapGrid RadioMapQuestion::grid(const Aabb& bounds, std::int64_t most) const {
  MapGrid grid;
  Vec3d across, down;
  if (origin) {
    grid.origin = *origin, across = *u, down = *v;
  } else {
    if (!area && bounds.empty())
      throw InputError({FaultKind::missing, "/area", std::nullopt,
                        "x0,z0,x1,z1, for nothing in the scene is bounded"});
    const std::array<double, 4> all =
        area ? *area : std::array{bounds.min.x, bounds.min.z, bounds.max.x, bounds.max.z};
    grid.origin = {all[0], height.value_or(usual_height), all[1]};
    across = {all[2] - all[0], 0, 0}, down = {0, 0, all[3] - all[1]};
  }
  const double wide = length(across), deep = length(down);
  const double side = cell.value_or(std::max(wide, deep) / 100);
  if (!(wide > 0 && deep > 0))
    throw InputError({FaultKind::missing, "/area", std::nullopt,
                      "x0,z0,x1,z1, for the scene's bounds have no area"});
  const double columns = count_of(wide, side), rows = count_of(deep, side);
  if (columns * rows > static_cast<double>(most))
    throw InputError({FaultKind::limit, "/cell", Value(side),
                      "what makes at most " + std::to_string(most) +
                          " cells, one for each transmitter (options TIA_MAX_PIXELS, "
                          "TIA_MAX_WORK)"});
  grid.cell = side;
  // A side of the plan is just as long as a cell.
  grid.across = origin ? across * (side / wide) : Vec3d{side, 0, 0};
  grid.down = origin ? down * (side / deep) : Vec3d{0, 0, side};
  grid.width = static_cast<int>(columns), grid.height = static_cast<int>(rows);
  return grid;
}

}  // namespace tia
