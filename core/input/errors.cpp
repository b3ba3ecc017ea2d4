#include "core/input/errors.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/input/edit_distance.h"
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

std::string nearest_name(std::string_view name, const std::vector<std::string_view>& known) {
  constexpr std::size_t most_edits = 5, most_tried = 2000;  // bound the work on hostile input
  if (name.empty() || name.size() > longest_compared) return "";
  std::string best;
  std::size_t fewest = std::min({1 + name.size() / 3, name.size() - 1, most_edits});
  for (const std::string_view candidate :
       std::span(known).first(std::min(most_tried, known.size()))) {
    const std::size_t edits = edits_to(candidate, name, fewest);
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
