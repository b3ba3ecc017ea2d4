#include "core/models/gltf/gltf_object.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/input/json.h"

namespace tia::gltf {
namespace {

std::string words(Range range) {
  if (range.min < -1e307 && range.max > 1e307) return "a number";
  if (range.max > 1e307) return "a number from " + number_text(range.min) + " on";
  return "a number from " + number_text(range.min) + " to " + number_text(range.max);
}
std::string integer_words(std::uint64_t least, std::uint64_t most) {
  return "an integer from " + std::to_string(least) + " to " + std::to_string(most);
}
std::string index_words(std::size_t size) {
  return size == 0 ? "nothing: the list that it means is not there"
                   : "an index from 0 to " + std::to_string(size - 1);
}

}  // namespace

GltfObject::GltfObject(const Value* value, const Place& at, Faults& faults)
    : object_(value == nullptr ? nullptr : value->as<Value::Object>()), at_(at), faults_(&faults) {
  if (value != nullptr && object_ == nullptr)
    faults.add({FaultKind::wrong_type, at.pointer(), excerpt(*value), "an object"});
}

const Value* GltfObject::member(std::string_view name) const {
  return object_ == nullptr ? nullptr : find(*object_, name);
}

bool GltfObject::needs(std::string_view name, std::string_view what) const {
  if (object_ != nullptr && !has(name))
    fault(FaultKind::missing, name, std::nullopt, std::string(what));
  return has(name);
}

void GltfObject::fault(FaultKind kind, std::optional<Value> got, std::string allowed) const {
  faults_->add({kind, at_.pointer(), std::move(got), std::move(allowed)});
}

void GltfObject::fault(FaultKind kind, std::string_view name, std::optional<Value> got,
                       std::string allowed) const {
  faults_->add({kind, at_.at(name).pointer(), std::move(got), std::move(allowed)});
}

bool GltfObject::take(const Value& value, const Place& at, Range range, double& out) const {
  const auto* number = value.as<double>();
  const bool in_range = number != nullptr && *number >= range.min && *number <= range.max;
  if (in_range) out = *number;
  else
    faults_->add({number == nullptr ? FaultKind::wrong_type : FaultKind::out_of_range, at.pointer(),
                  excerpt(value), words(range)});
  return in_range;
}

std::optional<double> GltfObject::number(std::string_view name, Range range) const {
  const Value* value = member(name);
  double out = 0;
  if (value == nullptr || !take(*value, at_.at(name), range, out)) return std::nullopt;
  return out;
}

std::optional<std::uint64_t> GltfObject::integer(std::string_view name, std::uint64_t least,
                                                 std::uint64_t most) const {
  const Value* value = member(name);
  if (value == nullptr) return std::nullopt;
  const auto* number = value->as<double>();
  if (number != nullptr && *number >= static_cast<double>(least) &&
      *number <= static_cast<double>(most) && *number == std::floor(*number))
    return static_cast<std::uint64_t>(*number);
  fault(number == nullptr ? FaultKind::wrong_type : FaultKind::out_of_range, name, excerpt(*value),
        integer_words(least, most));
  return std::nullopt;
}

MaybeIndex GltfObject::index(std::string_view name, std::size_t size) const {
  const Value* value = member(name);
  if (value == nullptr) return std::nullopt;
  const auto* number = value->as<double>();
  if (number != nullptr && *number >= 0 && *number < static_cast<double>(size) &&
      *number == std::floor(*number))
    return static_cast<ModelIndex>(*number);
  fault(number == nullptr ? FaultKind::wrong_type : FaultKind::out_of_range, name, excerpt(*value),
        index_words(size));
  return std::nullopt;
}

std::string GltfObject::text(std::string_view name) const {
  const Value* value = member(name);
  if (value == nullptr) return {};
  if (const auto* text = value->as<std::string>()) return *text;
  fault(FaultKind::wrong_type, name, excerpt(*value), "a text");
  return {};
}

bool GltfObject::flag(std::string_view name, bool standard) const {
  const Value* value = member(name);
  if (value == nullptr) return standard;
  if (const auto* flag = value->as<bool>()) return *flag;
  fault(FaultKind::wrong_type, name, excerpt(*value), "true or false");
  return standard;
}

const Value::Array* GltfObject::list(std::string_view name) const {
  const Value* value = member(name);
  if (value == nullptr) return nullptr;
  const auto* entries = value->as<Value::Array>();
  if (entries == nullptr) fault(FaultKind::wrong_type, name, excerpt(*value), "a list");
  else if (entries->empty()) fault(FaultKind::out_of_range, name, *value, "a list of some entries");
  return entries;
}

std::size_t GltfObject::size_of(std::string_view name) const {
  const Value* value = member(name);
  const auto* entries = value == nullptr ? nullptr : value->as<Value::Array>();
  return entries == nullptr ? 0 : entries->size();
}

bool GltfObject::fill(std::string_view name, double* out, std::size_t count, Range range) const {
  const Value::Array* entries = list(name);
  if (entries == nullptr || entries->empty()) return false;
  if (entries->size() != count) {
    fault(FaultKind::wrong_type, name, Value(std::to_string(entries->size()) + " entries"),
          std::to_string(count) + " numbers");
    return false;
  }
  const Place place = at_.at(name);
  bool all = true;
  for (std::size_t i = 0; i < count; ++i)
    all = take((*entries)[i], place.at(i), range, out[i]) && all;
  return all;
}

Color GltfObject::color_or(std::string_view name, const Color& standard, Range range) const {
  const auto rgb = numbers<3>(name, range);
  return rgb ? Color{(*rgb)[0], (*rgb)[1], (*rgb)[2]} : standard;
}

std::vector<ModelIndex> GltfObject::indices(std::string_view name, std::size_t size) const {
  std::vector<ModelIndex> all;
  const Value::Array* entries = list(name);
  if (entries == nullptr) return all;
  const Place place = at_.at(name);
  for (std::size_t i = 0; i < entries->size() && !faults_->full(); ++i) {
    double number = 0;
    const double last = size == 0 ? -1 : static_cast<double>(size - 1);
    if (!take((*entries)[i], place.at(i), {0, last}, number)) continue;
    if (number == std::floor(number)) all.push_back(static_cast<ModelIndex>(number));
    else
      faults_->add(
          {FaultKind::out_of_range, place.at(i).pointer(), Value(number), index_words(size)});
  }
  return all;
}

// The places of equal entries, sorted, lie side by side: the later ones are too many.
template <class Entry>
void GltfObject::each_once(std::string_view name, const std::vector<Entry>& entries) const {
  std::vector<std::size_t> order(entries.size()), twice;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return entries[a] != entries[b] ? entries[a] < entries[b] : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (entries[order[i]] == entries[order[i - 1]]) twice.push_back(order[i]);
  std::sort(twice.begin(), twice.end());
  const Place place = at_.at(name);
  for (const std::size_t at : twice) {
    if (faults_->full()) return;
    faults_->add({FaultKind::conflict, place.at(at).pointer(), std::nullopt, "each entry once"});
  }
}

std::vector<ModelIndex> GltfObject::unique_indices(std::string_view name, std::size_t size) const {
  std::vector<ModelIndex> all = indices(name, size);
  if (all.size() == size_of(name)) each_once(name, all);  // else their places are not known
  return all;
}

std::vector<double> GltfObject::number_list(std::string_view name, Range range) const {
  std::vector<double> all;
  const Value::Array* entries = list(name);
  if (entries == nullptr) return all;
  all.resize(entries->size());
  const Place place = at_.at(name);
  for (std::size_t i = 0; i < all.size() && !faults_->full(); ++i)
    take((*entries)[i], place.at(i), range, all[i]);
  return all;
}

std::vector<std::string> GltfObject::texts(std::string_view name) const {
  std::vector<std::string> all;
  const Value::Array* entries = list(name);
  if (entries == nullptr) return all;
  const Place place = at_.at(name);
  for (std::size_t i = 0; i < entries->size() && !faults_->full(); ++i) {
    if (const auto* text = (*entries)[i].as<std::string>()) all.push_back(*text);
    else
      faults_->add(
          {FaultKind::wrong_type, place.at(i).pointer(), excerpt((*entries)[i]), "a text"});
  }
  if (all.size() == entries->size()) each_once(name, all);
  return all;
}

}  // namespace tia::gltf
