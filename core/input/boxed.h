// Boxed: a value that lives on the heap, where it would make large what seldom has one of its own.
#pragma once

#include <memory>
#include <utility>

#include "core/input/codec.h"
#include "core/input/described.h"

namespace tia {

/// Boxed<T>: as a T, copied and compared as one. What it was moved from can only be assigned to.
template <class T>
class Boxed {
 public:
  Boxed() : value_(std::make_unique<T>()) {}
  Boxed(T value) : value_(std::make_unique<T>(std::move(value))) {}
  Boxed(const Boxed& other) : value_(std::make_unique<T>(*other)) {}
  Boxed(Boxed&&) noexcept = default;
  Boxed& operator=(const Boxed& other) { return *this = Boxed(other); }
  Boxed& operator=(Boxed&&) noexcept = default;
  ~Boxed() = default;

  const T& operator*() const { return *value_; }
  T& operator*() { return *value_; }
  const T* operator->() const { return value_.get(); }
  T* operator->() { return value_.get(); }
  bool operator==(const Boxed& other) const { return *value_ == *other; }

 private:
  std::unique_ptr<T> value_;
};

/// OptionalBox<T>: as an optional T, of which what is not there takes a pointer alone.
template <class T>
class OptionalBox {
 public:
  OptionalBox() = default;
  OptionalBox(T value) : value_(std::make_unique<T>(std::move(value))) {}
  OptionalBox(const OptionalBox& other) : value_(other ? std::make_unique<T>(*other) : nullptr) {}
  OptionalBox(OptionalBox&&) noexcept = default;
  OptionalBox& operator=(const OptionalBox& other) { return *this = OptionalBox(other); }
  OptionalBox& operator=(OptionalBox&&) noexcept = default;
  ~OptionalBox() = default;

  explicit operator bool() const { return value_ != nullptr; }
  const T& operator*() const { return *value_; }
  bool operator==(const OptionalBox& other) const {
    return value_ && other.value_ ? *value_ == *other.value_ : value_ == other.value_;
  }

 private:
  std::unique_ptr<T> value_;
};
template <class T>
inline constexpr bool detail::is_optional<OptionalBox<T>> = true;

template <class T>
struct Codec<OptionalBox<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   OptionalBox<T>& out) {
    T value{};
    const std::size_t before = faults.count();
    read_value(v, at, spec, faults, value);
    if (faults.count() == before) out = OptionalBox<T>(std::move(value));
  }
  static Value write(const OptionalBox<T>& v) { return v ? write_value(*v) : Value(); }
  static Value schema(const Spec& spec, Definitions& named) { return schema_of<T>(spec, named); }
  static std::string allowed(const Spec& spec) { return Codec<T>::allowed(spec); }
};

template <class T>
struct Codec<Boxed<T>> {
  static void read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                   Boxed<T>& out) {
    read_value(v, at, spec, faults, *out);
  }
  static Value write(const Boxed<T>& v) { return write_value(*v); }
  static Value schema(const Spec& spec, Definitions& named) { return schema_of<T>(spec, named); }
  static std::string allowed(const Spec& spec) { return Codec<T>::allowed(spec); }
};

}  // namespace tia
