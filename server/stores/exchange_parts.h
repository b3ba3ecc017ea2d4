// What all requests to a reader's process and its answers are made of: lines of JSON, numbers,
// faults.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/input/value.h"

namespace tia::server {

/// NoAnswer: bytes that no reader would answer with, unless something is wrong with it.
struct NoAnswer : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What an answer begins with.
inline constexpr std::uint8_t model_follows = 'M', files_follow = 'U', faults_follow = 'F';

/// A member of an object. Errors: std::runtime_error where there is none of that type.
template <class T>
const T& member(const Value& object, std::string_view name) {
  const auto* members = object.as<Value::Object>();
  const Value* value = members == nullptr ? nullptr : find(*members, name);
  const T* found = value == nullptr ? nullptr : value->as<T>();
  if (found == nullptr) throw std::runtime_error("no request: " + std::string(name));
  return *found;
}

template <class Number>
void put_number(Number number, std::vector<std::uint8_t>& bytes) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(&number);
  bytes.insert(bytes.end(), from, from + sizeof number);
}

/// The first bytes, which are taken off. Errors: NoAnswer where there are fewer.
inline std::span<const std::uint8_t> take(std::span<const std::uint8_t>& rest, std::uint64_t size) {
  if (size > rest.size()) throw NoAnswer("fewer bytes than it says");
  const auto part = rest.first(size);
  rest = rest.subspan(size);
  return part;
}
template <class Number>
Number take_number(std::span<const std::uint8_t>& rest) {
  Number number;
  std::memcpy(&number, take(rest, sizeof number).data(), sizeof number);
  return number;
}

/// The answer that tells faults, its letter included.
std::vector<std::uint8_t> faults_answer(const InputError& error);
/// Throws what such an answer tells after its letter, cut short, for anybody may have written it.
/// Errors: InputError; NoAnswer.
[[noreturn]] void raise_faults(std::span<const std::uint8_t> text);

}  // namespace tia::server
