// GltfObject: a JSON object of a glTF file with its place, and its members by their types. What is
// wrong with a member becomes a fault at its pointer; the caller goes on with its default.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model.h"

namespace tia::gltf {

/// Range: of a number, both ends allowed.
struct Range {
  double min = -1e308, max = 1e308;
};

/// GltfObject. Domain: the value, the parent of its place and the faults outlive it.
class GltfObject {
 public:
  /// What is no object is a fault, and then as one without members. Null: absent, without members.
  GltfObject(const Value* value, const Place& at, Faults& faults);

  const Place& at() const { return at_; }
  Faults& faults() const { return *faults_; }
  /// Whether it stood in the file, as an object.
  bool there() const { return object_ != nullptr; }
  bool has(std::string_view name) const { return member(name) != nullptr; }
  /// Whether it has a member; an object without it is a fault there.
  bool needs(std::string_view name, std::string_view what) const;
  const Value* member(std::string_view name) const;

  std::optional<double> number(std::string_view name, Range range = {}) const;
  double number_or(std::string_view name, double standard, Range range = {}) const {
    return number(name, range).value_or(standard);
  }
  /// An integer from `least` to `most`. Domain: least >= 0, most <= 2^53.
  std::optional<std::uint64_t> integer(std::string_view name, std::uint64_t least,
                                       std::uint64_t most) const;
  /// The number of an entry of a list of that size.
  MaybeIndex index(std::string_view name, std::size_t size) const;
  std::string text(std::string_view name) const;  ///< "" where there is none
  bool flag(std::string_view name, bool standard) const;
  /// A list of exactly n numbers.
  template <std::size_t n>
  std::optional<std::array<double, n>> numbers(std::string_view name, Range range = {}) const {
    std::array<double, n> out;
    return fill(name, out.data(), n, range) ? std::optional(out) : std::nullopt;
  }
  /// Three numbers of linear RGB.
  Color color_or(std::string_view name, const Color& standard, Range range = {0, 1}) const;
  /// Its entries, or null. A list without entries is a fault.
  const Value::Array* list(std::string_view name) const;
  /// A list of entry numbers of a list of that size.
  std::vector<ModelIndex> indices(std::string_view name, std::size_t size) const;
  /// The same, each number once.
  std::vector<ModelIndex> unique_indices(std::string_view name, std::size_t size) const;
  /// A list of any number of numbers.
  std::vector<double> number_list(std::string_view name, Range range = {}) const;
  /// A list of texts, each once.
  std::vector<std::string> texts(std::string_view name) const;
  /// Calls f(name, value) with each member, until the faults are full.
  template <class F>
  void for_each_member(F f) const {
    if (object_ == nullptr) return;
    for (const auto& [name, value] : *object_)
      if (!faults_->full()) f(std::string_view(name), value);
  }
  /// Calls f(object, number) with each entry of a list of objects, until the faults are full.
  template <class F>
  void for_each(std::string_view name, F f) const {
    const Value::Array* entries = list(name);
    if (entries == nullptr) return;
    const Place place = at_.at(name);
    for (std::size_t i = 0; i < entries->size() && !faults_->full(); ++i)
      f(GltfObject(&(*entries)[i], place.at(i), *faults_), i);
  }
  /// Calls f(object) with the member, an object, if it is there. Returns: whether it is.
  template <class F>
  bool with(std::string_view name, F f) const {
    if (!has(name)) return false;
    f(GltfObject(member(name), at_.at(name), *faults_));
    return true;
  }
  /// Calls f(object) with an extension's object, if it is there. Returns: whether it is.
  template <class F>
  bool with_extension(std::string_view name, F f) const {
    bool found = false;
    with("extensions", [&](const GltfObject& all) { found = all.with(name, f); });
    return found;
  }
  /// How many entries a list has, 0 without one.
  std::size_t size_of(std::string_view name) const;

  void fault(FaultKind kind, std::string_view name, std::optional<Value> got,
             std::string allowed) const;
  /// At the object itself.
  void fault(FaultKind kind, std::optional<Value> got, std::string allowed) const;

 private:
  template <class Entry>
  void each_once(std::string_view name, const std::vector<Entry>& entries) const;
  bool fill(std::string_view name, double* out, std::size_t count, Range range) const;
  bool take(const Value& value, const Place& at, Range range, double& out) const;

  const Value::Object* object_;
  Place at_;
  Faults* faults_;
};

}  // namespace tia::gltf
