#include "core/input/errors.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include "core/input/json.h"

namespace tia {

std::string Place::pointer() const {
  if (parent == nullptr && !is_index && key.empty()) return "";
  std::string text = parent != nullptr ? parent->pointer() : "";
  text += '/';
  if (is_index) return text + std::to_string(index);
  for (const char c : excerpt_of(key, longest_name)) {
    if (c == '~') text += "~0";
    else if (c == '/') text += "~1";
    else text += c;
  }
  return text;
}

namespace {

constexpr std::size_t longest_pointer = 512, longest_allowed = 1024;

// It remains a pointer: no ~ without its 0 or 1.
std::string excerpt_of_pointer(const std::string& pointer) {
  std::string text = excerpt_of(pointer, longest_pointer);
  if (text == pointer) return text;
  const std::size_t end = text.rfind("…");
  if (text[end - 1] == '~') text.erase(end - 1, 1);
  return text;
}

void shorten(Fault& fault) {
  fault.pointer = excerpt_of_pointer(fault.pointer);
  if (fault.got) fault.got = excerpt(*fault.got);
  fault.allowed = excerpt_of(fault.allowed, longest_allowed);
  fault.nearest = excerpt_of(fault.nearest, longest_name);
}

}  // namespace

void Faults::add(Fault fault) {
  ++count_;
  if (full()) return;
  shorten(fault);
  list_.push_back(std::move(fault));
}

bool Faults::at(std::string_view pointer) const {
  return std::any_of(list_.begin(), list_.end(),
                     [&](const Fault& fault) { return fault.pointer == pointer; });
}

bool Faults::within(std::string_view pointer) const {
  return std::any_of(list_.begin(), list_.end(), [&](const Fault& fault) {
    return fault.pointer.starts_with(pointer) &&
           (fault.pointer.size() == pointer.size() || fault.pointer[pointer.size()] == '/');
  });
}

void Faults::raise() const {
  if (!list_.empty()) throw InputError(list_);
}

bool Faults::take(Bulk bulk, std::int64_t count) {
  std::int64_t& left = left_[static_cast<std::size_t>(bulk)];
  if (count > left) return false;
  left -= count;
  return true;
}

InputError::InputError(std::vector<Fault> faults) : faults_(std::move(faults)) {
  for (Fault& fault : faults_) {
    shorten(fault);
    if (!text_.empty()) text_ += '\n';
    text_ += describe(fault);
  }
}

std::string describe(const Fault& fault) {
  std::string text = fault.pointer.empty() ? "" : fault.pointer + ": ";
  if (fault.line) text += "line " + std::to_string(*fault.line) + ": ";
  if (fault.got) text += "got " + to_json(*fault.got) + ", ";
  else if (fault.kind == FaultKind::missing) text += "missing, ";
  text += "allowed: " + fault.allowed;
  if (!fault.nearest.empty()) text += " (did you mean \"" + fault.nearest + "\"?)";
  return text;
}

namespace {

constexpr std::size_t longest_compared = 64;  // of names, in bytes

// Fewest insertions, deletions, substitutions and swaps of neighbours ("optimal string alignment"),
// three rows at a time; more than `most` where there are more. Only what lies within `most` of the
// diagonal can be that near, and a row that is nowhere so near leads to nothing nearer.
// Source: Ukkonen, "Algorithms for approximate string matching" (1985).
// Domain: texts of at most longest_compared bytes.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t most) {
  if (std::max(a.size(), b.size()) - std::min(a.size(), b.size()) > most) return most + 1;
  using Row = std::array<std::uint8_t, longest_compared + 1>;
  const auto too_many = static_cast<std::uint8_t>(most + 1);
  Row rows[3];
  for (Row& each : rows) each.fill(too_many);
  Row *before = &rows[0], *last = &rows[1], *row = &rows[2];
  for (std::size_t j = 0; j <= std::min(b.size(), most); ++j)
    (*row)[j] = static_cast<std::uint8_t>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::swap(before, last);
    std::swap(last, row);
    row->fill(too_many);
    if (i <= most) (*row)[0] = static_cast<std::uint8_t>(i);
    std::size_t fewest = (*row)[0];
    for (std::size_t j = i > most ? i - most : 1; j <= std::min(b.size(), i + most); ++j) {
      const std::size_t substituted = (*last)[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U);
      std::size_t edits = std::min<std::size_t>({(*last)[j] + 1U, (*row)[j - 1] + 1U, substituted});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        edits = std::min<std::size_t>(edits, (*before)[j - 2] + 1U);
      (*row)[j] = static_cast<std::uint8_t>(std::min(edits, most + 1));
      fewest = std::min(fewest, edits);
    }
    if (fewest > most) return most + 1;
  }
  return (*row)[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, const std::vector<std::string_view>& known) {
  constexpr std::size_t most_edits = 5, most_tried = 2000;  // bound the work on hostile input
  if (name.empty() || name.size() > longest_compared) return "";
  std::string best;
  std::size_t fewest = std::min({1 + name.size() / 3, name.size() - 1, most_edits});
  for (const std::string_view candidate :
       std::span(known).first(std::min(most_tried, known.size()))) {
    // Who writes a name's first word means it: fov is fov_degrees, not far.
    const bool begins =
        candidate.starts_with(name) && candidate.substr(name.size()).starts_with('_');
    const std::size_t edits =
        begins ? 1 : edit_distance(name, candidate.substr(0, longest_compared), fewest);
    if (edits < fewest || (edits == fewest && best.empty())) {
      fewest = edits;
      best = candidate;
    }
  }
  return best;
}

std::string listed(const std::vector<std::string_view>& names) {
  constexpr std::size_t most = 64, longest = 64, enough = 436;
  std::string text;
  std::size_t told = 0;
  for (; told < std::min(most, names.size()) && text.size() < enough; ++told) {
    if (!text.empty()) text += ", ";
    text += excerpt_of(names[told], longest);
  }
  if (told < names.size()) text += " and " + std::to_string(names.size() - told) + " more";
  return text;
}

}  // namespace tia
