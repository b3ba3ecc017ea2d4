#include "core/formulas/parse.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/formulas/tokens.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

// What waits on the stack for its right operand or its end.
struct Waiting {
  enum Kind { operation, minus, parenthesis, call } kind = operation;
  char symbol = 0;                            ///< of an operation
  const FormulaFunction* function = nullptr;  ///< of a call
  std::size_t arguments = 0;                  ///< that a call has had before the present one
  std::size_t column = 0;                     ///< of the sign or the parenthesis
};

int binding(const Waiting& w) {
  if (w.kind == Waiting::minus) return 3;
  return w.symbol == '^' ? 4 : w.symbol == '*' || w.symbol == '/' ? 2 : 1;
}
bool is_open(const Waiting& w) { return w.kind == Waiting::parenthesis || w.kind == Waiting::call; }
Op op_of(char symbol) {
  switch (symbol) {
    case '+': return Op::add;
    case '-': return Op::subtract;
    case '*': return Op::multiply;
    default: return Op::divide;
  }
}
std::string counted(std::size_t n) {
  return std::to_string(n) + (n == 1 ? " argument" : " arguments");
}

constexpr const char* an_operand = "a number, a name, a function, - or (";

class Reader {
 public:
  Reader(const std::string& text, const FormulaNames& names, const Place& at,
         ProgramBuilder& builder, Faults& faults)
      : text_(text), tokens_(text), names_(names), at_(at), builder_(builder), faults_(faults) {}

  int read() {
    if (text_.size() > most_formula_bytes)
      return limit(1, "a formula of at most " + std::to_string(most_formula_bytes) + " bytes");
    for (;;) {
      if (!operand()) return -1;
      for (;;) {  // what may follow an operand
        const Token next = tokens_.next();
        if (next.kind == Token::symbol && next.is(')')) {
          if (!close(next)) return -1;
          continue;
        }
        if (next.kind == Token::end) return finish(next);
        if (!after_operand(next)) return -1;
        break;
      }
      if (builder_.cost() > most_formula_cost) return too_costly(tokens_.column());
    }
  }

 private:
  // ---- operands -------------------------------------------------------------------------------

  // Reads up to and with one operand: what opens before it waits.
  bool operand() {
    for (;;) {
      const Token token = tokens_.next();
      if (token.kind == Token::number) {
        if (!std::isfinite(token.value))
          return unexpected(token, "a number that a double can hold");
        return have(builder_.constant(token.value));
      }
      if (token.kind == Token::name) {
        if (const FormulaFunction* function = function_of(token.text)) {
          const Token open = tokens_.next();
          if (!open.is('(')) return unexpected(open, "( after " + std::string(token.text));
          if (!wait({Waiting::call, 0, function, 0, open.column})) return false;
          continue;
        }
        return named(token);
      }
      if (token.is('-')) {
        if (!wait({Waiting::minus, 0, nullptr, 0, token.column})) return false;
      } else if (token.is('(')) {
        if (!wait({Waiting::parenthesis, 0, nullptr, 0, token.column})) return false;
      } else {
        return unexpected(token, an_operand);
      }
    }
  }
  bool named(const Token& token) {
    for (std::size_t i = 0; i < names_.variables.size(); ++i)
      if (names_.variables[i] == token.text)
        return have(names_.terms.empty() ? builder_.variable(static_cast<int>(i))
                                         : names_.terms[i]);
    const auto found = names_.parameters.find(std::string(token.text));
    if (found != names_.parameters.end()) return have(builder_.constant(found->second));
    if (token.text == "pi") return have(builder_.constant(pi));
    const std::vector<std::string_view> known = names_.known();
    fault(FaultKind::unknown_name, token.column, describe(token) + ": one of " + listed(known),
          nearest_name(token.text, known));
    return false;
  }
  bool have(int term) {
    terms_.push_back(term);
    return true;
  }

  // ---- what follows them ----------------------------------------------------------------------

  bool after_operand(const Token& token) {
    if (token.is(',')) return next_argument(token);
    if (token.kind != Token::symbol ||
        std::string_view("+-*/^").find(token.text[0]) == std::string_view::npos)
      return unexpected(token, expected_after());
    const Waiting own{Waiting::operation, token.text[0], nullptr, 0, token.column};
    // `^` is right-associative: 2 ^ 3 ^ 2 = 2 ^ 9.
    reduce(own.symbol == '^' ? binding(own) + 1 : binding(own));
    return wait(own);
  }
  std::string expected_after() const {
    const auto open = std::find_if(waiting_.rbegin(), waiting_.rend(), is_open);
    std::string expected = "+, -, *, /, ^";
    if (open == waiting_.rend()) return expected + " or the end";
    return expected + (open->kind == Waiting::call ? ", a comma or )" : " or )");
  }
  bool next_argument(const Token& comma) {
    reduce(0);
    if (waiting_.empty() || waiting_.back().kind != Waiting::call)
      return unexpected(comma, expected_after());
    Waiting& call = waiting_.back();
    if (++call.arguments == call.function->arguments) return wrong_count(comma, call);
    return true;
  }
  bool wrong_count(const Token& token, const Waiting& call) {
    return unexpected(token, "): " + std::string(call.function->name) + " takes " +
                                 counted(call.function->arguments));
  }
  bool close(const Token& token) {
    reduce(0);
    if (waiting_.empty()) return unexpected(token, expected_after());
    const Waiting open = waiting_.back();
    waiting_.pop_back();
    if (open.kind == Waiting::parenthesis) return true;
    const std::size_t had = open.arguments + 1;
    if (had != open.function->arguments)
      return unexpected(token, "a comma: " + std::string(open.function->name) + " takes " +
                                   counted(open.function->arguments) + ", not " +
                                   std::to_string(had));
    const int last = take();
    terms_.push_back(had == 1 ? builder_.operation(open.function->op, last)
                              : builder_.operation(open.function->op, take(), last));
    return true;
  }
  int finish(const Token& end) {
    reduce(0);
    if (!waiting_.empty()) {
      unexpected(end, ") for the ( of column " + std::to_string(waiting_.back().column));
      return -1;
    }
    return builder_.cost() > most_formula_cost ? too_costly(end.column) : terms_.front();
  }

  // ---- the stacks -----------------------------------------------------------------------------

  bool wait(const Waiting& each) {
    if (waiting_.size() == most_formula_depth) {
      limit(each.column, "at most " + std::to_string(most_formula_depth) +
                             " signs and parentheses open at once");
      return false;
    }
    waiting_.push_back(each);
    return true;
  }
  // Makes terms of what binds at least as tightly, back to what is open.
  void reduce(int least) {
    while (!waiting_.empty() && !is_open(waiting_.back()) && binding(waiting_.back()) >= least) {
      const Waiting own = waiting_.back();
      waiting_.pop_back();
      const int right = take();
      if (own.kind == Waiting::minus) have(builder_.operation(Op::negate, right));
      else if (own.symbol == '^') have(builder_.power(take(), right));
      else have(builder_.operation(op_of(own.symbol), take(), right));
    }
  }
  int take() {
    const int term = terms_.back();
    terms_.pop_back();
    return term;
  }

  // ---- faults ---------------------------------------------------------------------------------

  static std::string describe(const Token& token) {
    constexpr std::size_t longest = 64;
    if (token.kind == Token::end) return "the end";
    std::string quoted = "'";
    quoted += token.text.substr(0, longest);
    quoted += token.text.size() > longest ? "…'" : "'";
    return quoted;
  }
  bool unexpected(const Token& token, const std::string& expected) {
    fault(FaultKind::out_of_range, token.column, "not " + describe(token) + " but " + expected, "");
    return false;
  }
  int too_costly(std::size_t column) {
    return limit(
        column, "a formula that costs at most " + std::to_string(most_formula_cost) + " additions");
  }
  int limit(std::size_t column, const std::string& allowed) {
    fault(FaultKind::limit, column, allowed, "");
    return -1;
  }
  void fault(FaultKind kind, std::size_t column, const std::string& allowed,
             const std::string& nearest) {
    faults_.add({kind, at_.pointer(), Value(text_),
                 "at column " + std::to_string(column) + " " + allowed, nearest, column});
  }

  const std::string& text_;
  Tokens tokens_;
  const FormulaNames& names_;
  const Place& at_;
  ProgramBuilder& builder_;
  Faults& faults_;
  std::vector<Waiting> waiting_;
  std::vector<int> terms_;
};

}  // namespace

int read_formula(const std::string& text, const FormulaNames& names, const Place& at,
                 ProgramBuilder& builder, Faults& faults) {
  return Reader(text, names, at, builder, faults).read();
}

void check_formulas(const std::vector<std::pair<const char*, std::string>>& formulas,
                    const FormulaNames& names, const Place& at, Faults& faults) {
  check_parameters(names, at.at("parameters"), faults);
  ProgramBuilder builder;
  for (const auto& [key, text] : formulas) read_formula(text, names, at.at(key), builder, faults);
}

Program program_of(const std::vector<std::string_view>& texts, const FormulaNames& names) {
  ProgramBuilder builder;
  Faults faults;
  std::vector<int> results;
  for (const std::string_view text : texts)
    results.push_back(read_formula(std::string(text), names, {}, builder, faults));
  faults.raise();
  return builder.program(results);
}

}  // namespace tia
