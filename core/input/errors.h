// What is wrong with an input: where, what came, what is allowed. HTTP's words for it are the
// server's business.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input/value.h"
#include "core/parallel/stopped.h"

namespace tia {

enum class FaultKind {
  malformed,
  unknown_name,
  wrong_type,
  out_of_range,
  missing,
  conflict,
  limit,
  unreadable  ///< of a file that came whole, by its format
};

/// Fault: one thing wrong at one place. Those that are collected or thrown are short: their texts
/// are excerpts of what is longer, for answers repeat them.
struct Fault {
  FaultKind kind = FaultKind::malformed;
  std::string pointer;       ///< RFC 6901 pointer into the input; "" is the whole;
                             ///< "/abc… (3912 bytes more)" is the start of a long one
  std::optional<Value> got;  ///< what stood there; none where something is missing
  std::string allowed;       ///< in words, with units
  std::string nearest = {};  ///< for an unknown name: the nearest known one, else ""
  std::optional<std::size_t> column = {};  ///< inside a formula: where, from 1, in bytes
  std::optional<std::size_t> line = {};    ///< of a file of lines: which, from 1
};

/// Place: a spot in a JSON text while it is read, linked to its parent; costs nothing until asked.
struct Place {
  const Place* parent = nullptr;
  std::string_view key = {};
  std::size_t index = 0;
  bool is_index = false;

  Place at(std::string_view name) const { return {this, name, 0, false}; }
  Place at(std::size_t i) const { return {this, {}, i, true}; }
  /// RFC 6901: ~ and / inside a name are written ~0 and ~1. Of a long name it has an excerpt.
  std::string pointer() const;
};

/// The most bytes that a name may have which answers repeat: an object's, a material's, a key's, a
/// parameter's.
inline constexpr std::size_t longest_name = 256;

/// The text, or its start and how much is left out: "abc… (3912 bytes more)", cut between two
/// characters. Returns: what takes at most `most` bytes as a JSON string, its quotes not counted;
/// an excerpt is its own excerpt. Domain: most >= 64.
std::string excerpt_of(std::string_view text, std::size_t most);

/// What came, or the start of its text where that is longer than 120 bytes: an answer must not echo
/// a mesh. Cost: it neither copies nor writes out what is long.
Value excerpt(const Value& got);

/// Bulk: things of which a few bytes of an input can hold millions: its pictures' pixels, those
/// that are gone over when they are read (a JPEG of many scans goes over all of them with each),
/// its grids' cells.
enum class Bulk { pixels, scanned_pixels, cells };
/// The most that a whole input may hold. Of scanned pixels that takes about a second.
constexpr std::int64_t most_of(Bulk bulk) {
  switch (bulk) {
    case Bulk::pixels: return 1 << 24;
    case Bulk::scanned_pixels: return 1 << 27;
    case Bulk::cells: break;
  }
  return 1 << 25;
}

/// Faults: collects all faults of an input, keeps the first 20, each cut short. It also counts what
/// comes in bulk, and ends reading that nobody wants any more.
class Faults {
 public:
  static constexpr std::size_t most = 20;
  explicit Faults(std::stop_token stop = {}) : stop_(std::move(stop)) {}
  void add(Fault fault);
  /// How many were added, those that were not kept included.
  std::size_t count() const { return count_; }
  bool empty() const { return list_.empty(); }
  /// Whether something is wrong exactly at a place.
  bool at(std::string_view pointer) const;
  /// Whether something is wrong at a place or anywhere inside it.
  bool within(std::string_view pointer) const;
  /// Nothing more will be kept: reading on would only cost time. Readers of lists ask before each
  /// element. Errors: Stopped, some thousand questions after that is asked for.
  bool full() const {
    if (++asked_ % 4096 == 0) end_if_asked(stop_);
    return list_.size() == most;
  }
  const std::vector<Fault>& list() const { return list_; }
  /// What ends reading.
  const std::stop_token& stop() const { return stop_; }
  /// Errors: throws InputError if anything was added.
  void raise() const;

  /// Takes so many from those that the whole input may hold. Returns: whether so many were left;
  /// else none are taken.
  bool take(Bulk bulk, std::int64_t count);
  /// How many have been taken.
  std::int64_t taken(Bulk bulk) const {
    return most_of(bulk) - left_[static_cast<std::size_t>(bulk)];
  }

 private:
  std::vector<Fault> list_;
  std::size_t count_ = 0;
  std::stop_token stop_;
  mutable unsigned asked_ = 0;
  std::array<std::int64_t, 3> left_{most_of(Bulk::pixels), most_of(Bulk::scanned_pixels),
                                    most_of(Bulk::cells)};
};

/// InputError: an input that cannot be used, with every fault found in it, each cut short.
class InputError : public std::exception {
 public:
  explicit InputError(std::vector<Fault> faults);
  explicit InputError(Fault fault) : InputError(std::vector<Fault>{std::move(fault)}) {}
  const std::vector<Fault>& faults() const { return faults_; }
  /// One line a fault: pointer, what came, what is allowed.
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::vector<Fault> faults_;
  std::string text_;
};

/// One line in words: "/objects/3/radius: got -1, allowed: a number above 0"; of a file of lines
/// "line 12: got ...".
std::string describe(const Fault& fault);

/// The known name nearest to the one given (fewest edits), or "" where none is near. Of many known
/// ones the first 2000 are tried.
std::string nearest_name(std::string_view name, const std::vector<std::string_view>& known);

/// The names as a list in words, "a, d, s, w": of many the first 64, or some 440 bytes; of long
/// ones the start.
std::string listed(const std::vector<std::string_view>& names);

}  // namespace tia
