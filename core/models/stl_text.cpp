#include <cmath>
#include <string>

#include "core/models/stl_solid.h"
#include "core/models/text_words.h"

namespace tia {
namespace {

// The words of a text one after the other, with their lines.
class StlWords {
 public:
  explicit StlWords(std::string_view text) : left_(text) {}

  /// The next word, "" at the end.
  std::string_view next() {
    skip_white();
    return cut_word(left_);
  }
  bool at_end() {
    skip_white();
    return left_.empty();
  }
  /// What stands behind the last word on its line.
  std::string_view rest_of_line() {
    const std::string_view rest = left_.substr(0, left_.find_first_of("\r\n"));
    left_.remove_prefix(rest.size());
    return trimmed(rest);
  }
  /// That of the last word, from 1.
  std::size_t line() const { return line_; }

 private:
  // A line ends with CR, LF or both.
  void skip_white() {
    for (; !left_.empty() && is_white(left_.front()); left_.remove_prefix(1))
      if (left_.front() == '\n' || (left_.front() == '\r' && !left_.starts_with("\r\n"))) ++line_;
  }

  std::string_view left_;
  std::size_t line_ = 1;
};

class StlTextReader {
 public:
  StlTextReader(std::string_view text, const ModelLimits& limits, Faults& faults, Model& model)
      : words_(text), limits_(limits), faults_(faults), model_(model) {}

  void read() {
    do {
      if (!solid()) return;
    } while (!words_.at_end());
  }

 private:
  bool solid() {
    if (!expect("solid")) return false;
    solid_.line = words_.line();
    solid_.name = words_.rest_of_line();
    solid_.vertices.take();  // of what was refused
    for (;;) {
      const std::string_view word = words_.next();
      if (is_word(word, "endsolid")) break;
      if (!is_word(word, "facet")) return refuse(word, "facet or endsolid");
      if (faults_.full() || !facet()) return false;
    }
    words_.rest_of_line();
    if (!faults_.empty()) return true;
    if (!solid_.vertices.empty()) return add_stl_solid(solid_, limits_, faults_, model_);
    model_.warn({"", *solid_.line, "a solid without facets is left out"});
    return true;
  }

  bool facet() {
    if (!check_stl_triangles(++triangles_, limits_, faults_) || !expect("normal")) return false;
    for (int i = 0; i < 3; ++i) words_.next();  // which is not used, so it may be anything
    return expect("outer") && expect("loop") && vertex() && vertex() && vertex() &&
           expect("endloop") && expect("endfacet");
  }
  bool vertex() {
    if (!expect("vertex")) return false;
    StlPoint point{};
    bool is_near = true;
    for (double& coordinate : point) {
      const std::string_view word = words_.next();
      const std::optional<double> number = number_in(word);
      if (!number) return refuse(word, "a number");
      coordinate = *number;
      if (std::fabs(coordinate) <= most_coordinate) continue;
      is_near = false;
      fault(FaultKind::out_of_range, word, "a number from -1e9 to 1e9");
    }
    if (is_near) solid_.vertices.add(point);
    return true;
  }

  bool expect(std::string_view small) {
    const std::string_view word = words_.next();
    return is_word(word, small) || refuse(word, std::string(small));
  }
  bool refuse(std::string_view word, const std::string& allowed) {
    fault(FaultKind::malformed, word.empty() ? "the end of the file" : word, allowed);
    return false;
  }
  void fault(FaultKind kind, std::string_view got, const std::string& allowed) {
    faults_.add({kind, "", Value(got), allowed, "", std::nullopt, words_.line()});
  }

  StlWords words_;
  const ModelLimits& limits_;
  Faults& faults_;
  Model& model_;
  StlSolid solid_;
  std::uint64_t triangles_ = 0;
};

}  // namespace

void read_stl_text(std::string_view text, const ModelLimits& limits, Faults& faults, Model& model) {
  StlTextReader(text, limits, faults, model).read();
}

}  // namespace tia
