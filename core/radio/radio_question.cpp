#include "core/radio/radio_question.h"

namespace tia {
namespace {

void check_count(std::size_t count, std::size_t most, const char* name, const Place& at,
                 Faults& faults) {
  if (count > most)
    faults.add({FaultKind::limit, at.at(name).pointer(), Value(std::to_string(count)),
                "at most " + std::to_string(most)});
}

}  // namespace

void ChannelQuestion::check(const Place& at, Faults& faults) const {
  check_count(offsets_hz.size(), most, "offsets_hz", at, faults);
  check_count(taps_s.size(), most, "taps_s", at, faults);
}

void RadioQuestion::check(const Place& at, Faults& faults) const {
  check_count(transmitters.size(), most_antennas, "transmitters", at, faults);
  check_count(receivers.size(), most_antennas, "receivers", at, faults);
}

}  // namespace tia
