// The statements of OBJ and MTL files, line by line, and their words and numbers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model_files.h"

namespace tia {

/// ObjLines: a file's lines, each without its end, which is LF or CRLF. Where a line ends in a
/// backslash the next one is its continuation, and a blank stands for what is between. A byte order
/// mark is passed over. Cost: linear in the file.
class ObjLines {
 public:
  explicit ObjLines(ModelBytes file);

  /// Goes on to the next line. Returns: whether there is one.
  bool next();
  /// Lives until next() is called.
  std::string_view line() const { return line_; }
  /// Where it begins, from 1.
  std::size_t number() const { return number_; }
  /// Whether nothing follows it.
  bool is_last() const { return rest_.empty(); }
  /// Bytes that follow it.
  std::size_t left() const { return rest_.size(); }

 private:
  std::string_view take();
  void join();

  std::string_view rest_, line_;
  std::size_t number_ = 0, taken_ = 0;
  std::string joined_;
};

/// How numbers of a line come out.
enum class ObjNumber { taken, absent, malformed, too_large };

/// ObjWords: what is left of a line's words. A word that begins with # ends them: a comment.
class ObjWords {
 public:
  explicit ObjWords(std::string_view line) : at_(line.data()), end_(at_ + line.size()) {}

  /// Whether there is no word left.
  bool empty() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    return at_ == end_ || *at_ == '#';
  }
  /// Takes a word. Returns: "" where there is none.
  std::string_view take();
  /// Takes a word that is a number, to the nearest double; '+' may stand before it. What is nearer
  /// to 0 than any is 0. What is no finite number stays; `absent` where no word is left.
  ObjNumber take(double& number);
  /// What is left, comments too. Domain: not empty.
  std::string_view left() const { return {at_, static_cast<std::size_t>(end_ - at_)}; }
  /// Takes that many bytes of it, where a word ends there. Returns: whether one does.
  bool skip(std::size_t bytes) {
    if (at_ + bytes != end_ && !is_blank(at_[bytes])) return false;
    at_ += bytes;
    return true;
  }
  /// All that is left, without blanks around it: names may have blanks and # inside.
  std::string_view rest();

 private:
  static bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  const char* take_short(double& number) const;

  const char *at_, *end_;
};

/// A fault in a line.
inline Fault obj_fault(FaultKind kind, std::size_t line, std::string_view got, std::string allowed,
                       std::string pointer = {}) {
  Fault fault{kind, std::move(pointer), Value(got), std::move(allowed)};
  fault.line = line;
  return fault;
}

}  // namespace tia
