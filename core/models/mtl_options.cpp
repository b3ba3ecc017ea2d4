#include "core/models/mtl_options.h"

#include <algorithm>
#include <span>
#include <string>

namespace tia {
namespace {

enum class MtlOptionUse { scale, offset, strength, clamp, harmless, not_taken };

constexpr double mtl_most_option = 1e9;

/// MtlOption: its name, and what comes after it.
struct MtlOption {
  std::string_view name;
  MtlOptionUse use;
  unsigned least, most;  ///< words after it; beyond the least only numbers
};
constexpr std::array<MtlOption, 14> mtl_options{{
    {"-s", MtlOptionUse::scale, 1, 3},
    {"-o", MtlOptionUse::offset, 1, 3},
    {"-bm", MtlOptionUse::strength, 1, 1},
    {"-clamp", MtlOptionUse::clamp, 1, 1},
    {"-blendu", MtlOptionUse::harmless, 1, 1},
    {"-blendv", MtlOptionUse::harmless, 1, 1},
    {"-boost", MtlOptionUse::harmless, 1, 1},
    {"-texres", MtlOptionUse::harmless, 1, 1},
    {"-cc", MtlOptionUse::not_taken, 1, 1},
    {"-imfchan", MtlOptionUse::not_taken, 1, 1},
    {"-mm", MtlOptionUse::not_taken, 2, 2},
    {"-t", MtlOptionUse::not_taken, 1, 3},
    {"-type", MtlOptionUse::not_taken, 1, 1},
    {"-colorspace", MtlOptionUse::not_taken, 1, 1},
}};

// The option whose name comes next; null, and nothing taken, where there is none.
const MtlOption* take_mtl_option(ObjWords& words) {
  ObjWords ahead = words;
  const std::string_view name = ahead.take();
  const auto* found = std::find_if(mtl_options.begin(), mtl_options.end(),
                                   [&](const MtlOption& option) { return option.name == name; });
  if (found == mtl_options.end()) return nullptr;
  words = ahead;
  return found;
}

bool take_mtl_numbers(const MtlOption& option, ObjWords& words, MtlReading& reading,
                      std::span<double> numbers) {
  for (unsigned i = 0; i < option.most; ++i) {
    double number = 0;
    const ObjNumber got = words.take(number);
    const bool is_far = number < -mtl_most_option || number > mtl_most_option;
    if (got != ObjNumber::taken && i >= option.least) return true;
    if (got != ObjNumber::taken || is_far) {
      reading.fault(
          is_far || got == ObjNumber::too_large ? FaultKind::out_of_range : FaultKind::malformed,
          reading.line(), std::string(option.name) + " and numbers within 1e9 of 0");
      return false;
    }
    if (i < numbers.size()) numbers[i] = number;
  }
  return true;
}

bool take_mtl_clamp(ObjWords& words, MtlReading& reading, MtlOptions& options) {
  const std::string_view word = words.take();
  options.clamp = word == "on";
  if (word == "on" || word == "off") return true;
  reading.fault(FaultKind::malformed, reading.line(), "-clamp and on or off");
  return false;
}

void pass_over_mtl(const MtlOption& option, ObjWords& words) {
  double number = 0;
  for (unsigned i = 0; i < option.most; ++i)
    if (i < option.least) words.take();
    else if (words.take(number) != ObjNumber::taken) return;
}

}  // namespace

bool read_mtl_options(std::string_view statement, ObjWords& words, MtlReading& reading,
                      MtlOptions& options) {
  while (const MtlOption* option = take_mtl_option(words)) {
    bool is_good = true;
    switch (option->use) {
      case MtlOptionUse::scale:
        is_good = take_mtl_numbers(*option, words, reading, options.scale);
        break;
      case MtlOptionUse::offset:
        is_good = take_mtl_numbers(*option, words, reading, options.offset);
        break;
      case MtlOptionUse::strength:
        is_good = take_mtl_numbers(*option, words, reading, {&options.strength, 1});
        break;
      case MtlOptionUse::clamp: is_good = take_mtl_clamp(words, reading, options); break;
      case MtlOptionUse::not_taken: {
        const std::string name = std::string(statement) + " " + std::string(option->name);
        reading.warn_once(name, name + ": this option is not taken");
        [[fallthrough]];
      }
      case MtlOptionUse::harmless: pass_over_mtl(*option, words); break;
    }
    if (!is_good) return false;
  }
  return true;
}

}  // namespace tia
