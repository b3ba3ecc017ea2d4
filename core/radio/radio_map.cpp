#include "core/radio/radio_map.h"

#include <cmath>
#include <limits>

#include "core/radio/decibels.h"
#include "core/radio/map_cells.h"

namespace tia {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

RadioQuestion search_question(const RadioMapQuestion& question) {
  RadioQuestion search = question;
  search.transmitters = question.senders();
  return search;
}

void check_map(const RadioWorld& world, const RadioMapQuestion& question,
               const RadioQuestion& search, const RadioLimits& limits, const Workers& workers) {
  Faults faults(workers.stop());
  check_antennas(
      world, search.transmitters, [&](std::size_t i) { return question.pointer_to(i); }, faults);
  check_search(world, search, limits, Place{}, faults);
  faults.raise();
}

MapGrid grid_of(const RadioWorld& world, const RadioMapQuestion& question,
                const MapLimits& limits) {
  const auto senders = static_cast<std::int64_t>(question.senders().size());
  return question.grid(world.bounds(), std::min(limits.max_cells, limits.max_images / senders));
}

// In a cell: what is received of each transmitter, dBm, and its numbers.
class CellPowers {
 public:
  CellPowers(const RadioMapQuestion& question, const std::vector<Antenna>& senders,
             const std::vector<SenderCells>& received)
      : question_(question), senders_(senders), received_(received) {
    const double bandwidth = decibels_of(question.bandwidth_hz);
    noise_ = power_of_decibels(question.noise_dbm.value_or(question.thermal_dbm + bandwidth));
  }

  double operator()(std::size_t cell) const {
    const std::size_t best = best_at(cell);
    if (best == senders_.size()) return none;
    switch (question_.quantity) {
      case MapQuantity::gain: return received_[best].gain_db[cell];
      case MapQuantity::power: return senders_.size() == 1 ? dbm(0, cell) : decibels_of(all(cell));
      case MapQuantity::delay_spread: return received_[best].delay_spread_s[cell];
      case MapQuantity::best_server: return static_cast<double>(best);
      case MapQuantity::sinr: break;
    }
    double others = noise_;
    for (std::size_t i = 0; i < senders_.size(); ++i)
      if (i != best) others += milliwatts(i, cell);
    return dbm(best, cell) - decibels_of(others);
  }

 private:
  double dbm(std::size_t i, std::size_t cell) const {
    return senders_[i].power_dbm + received_[i].gain_db[cell];
  }
  double milliwatts(std::size_t i, std::size_t cell) const {
    const double power = dbm(i, cell);
    return std::isnan(power) ? 0 : power_of_decibels(power);
  }
  double all(std::size_t cell) const {
    double sum = 0;
    for (std::size_t i = 0; i < senders_.size(); ++i) sum += milliwatts(i, cell);
    return sum;
  }
  // The first of those that are received best; as many as there are where none is.
  std::size_t best_at(std::size_t cell) const {
    std::size_t best = senders_.size();
    for (std::size_t i = 0; i < senders_.size(); ++i) {
      if (std::isnan(received_[i].gain_db[cell])) continue;
      if (best == senders_.size() || dbm(i, cell) > dbm(best, cell)) best = i;
    }
    return best;
  }

  const RadioMapQuestion& question_;
  const std::vector<Antenna>& senders_;
  const std::vector<SenderCells>& received_;
  double noise_;
};

}  // namespace

MapGrid grid_of(const Scene& scene, const RadioMapQuestion& question, const MapLimits& limits) {
  return grid_of(RadioWorld(scene, {question.frequency_hz}), question, limits);
}

std::string_view unit_of(MapQuantity quantity) {
  constexpr std::array<std::string_view, 5> units{"dB", "dBm", "s", "transmitter", "dB"};
  return units[static_cast<std::size_t>(quantity)];
}

RadioMap radio_map(const Scene& scene, const RadioMapQuestion& question, const MapLimits& limits,
                   const Workers& workers) {
  const RadioQuestion search = search_question(question);
  const RadioWorld world(scene, {question.frequency_hz}, workers);
  check_map(world, question, search, limits, workers);
  RadioMap map;
  map.grid = grid_of(world, question, limits);
  map.transmitters = search.transmitters.size();
  map.inside = cells_inside(world, map.grid, workers);
  map.walls = walls_in(world, map.grid);
  std::vector<SenderCells> received;
  for (const Antenna& sender : search.transmitters)
    received.push_back(
        received_of(sender, {world, question, map.grid, map.inside, limits}, workers, map.counts));
  const CellPowers value(question, search.transmitters, received);
  map.values.resize(map.inside.size());
  for (std::size_t i = 0; i < map.values.size(); ++i) map.values[i] = value(i);
  return map;
}

RadioQuestion paths_question(const RadioMapQuestion& question, const MapGrid& grid, int column,
                             int row) {
  RadioQuestion paths = search_question(question);
  Antenna receiver;
  receiver.position = grid.center(column, row);
  receiver.polarization = paths.transmitters.front().polarization;
  paths.receivers = {receiver};
  return paths;
}

}  // namespace tia
