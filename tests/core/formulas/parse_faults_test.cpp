// What is wrong with a formula's text: which column, what stands there, what was expected.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/formulas/parse.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using testing::HasSubstr;

const FormulaNames names_and_radius{{"x", "y"}, {{"radius", 2}}};

std::vector<Fault> formula_faults(const std::string& text) {
  ProgramBuilder builder;
  Faults faults;
  const int term = read_formula(text, names_and_radius, Place{}.at("formula"), builder, faults);
  EXPECT_EQ(term == -1, !faults.empty()) << text;
  return faults.list();
}
Fault formula_fault(const std::string& text) {
  const std::vector<Fault> all = formula_faults(text);
  EXPECT_EQ(all.size(), 1U) << text;
  return all.empty() ? Fault{} : all.front();
}

struct FaultyText {
  std::string text;
  std::size_t column;
  std::string allowed;  ///< what the fault says after the column
};

void expect_columns(const std::vector<FaultyText>& cases) {
  for (const FaultyText& each : cases) {
    const Fault fault = formula_fault(each.text);
    EXPECT_EQ(fault.column, each.column) << each.text;
    EXPECT_EQ(fault.allowed, "at column " + std::to_string(each.column) + " " + each.allowed)
        << each.text;
    EXPECT_EQ(fault.pointer, "/formula");
    EXPECT_EQ(fault.kind, FaultKind::out_of_range);
  }
}

const std::string operand = "a number, a name, a function, - or (";

TEST(ParseFaults, WhereAnOperandIsMissing) {
  expect_columns({{"", 1, "not the end but " + operand},
                  {"   ", 4, "not the end but " + operand},
                  {"x+", 3, "not the end but " + operand},
                  {"x + * y", 5, "not '*' but " + operand},
                  {"+x", 1, "not '+' but " + operand},
                  {"()", 2, "not ')' but " + operand},
                  {"sin()", 5, "not ')' but " + operand},
                  {"max(,1)", 5, "not ',' but " + operand},
                  {"max(1,)", 7, "not ')' but " + operand},
                  {"-", 2, "not the end but " + operand},
                  {"x^", 3, "not the end but " + operand},
                  {"x*$", 3, "not '$' but " + operand},
                  {".", 1, "not '.' but " + operand}});
}

TEST(ParseFaults, WhereAnOperatorIsMissing) {
  const std::string operators = "+, -, *, /, ^";
  expect_columns({{"2x", 2, "not 'x' but " + operators + " or the end"},
                  {"x y", 3, "not 'y' but " + operators + " or the end"},
                  {"x 2.5", 3, "not '2.5' but " + operators + " or the end"},
                  {"(x y)", 4, "not 'y' but " + operators + " or )"},
                  {"x(2)", 2, "not '(' but " + operators + " or the end"},
                  {"sin(x y)", 7, "not 'y' but " + operators + ", a comma or )"},
                  {"x)", 2, "not ')' but " + operators + " or the end"},
                  {"x,y", 2, "not ',' but " + operators + " or the end"},
                  {"(x,y)", 3, "not ',' but " + operators + " or )"},
                  {"1..2", 3, "not '.2' but " + operators + " or the end"},
                  {"0x10", 2, "not 'x10' but " + operators + " or the end"},
                  {"2e", 2, "not 'e' but " + operators + " or the end"},
                  {"2e+x", 2, "not 'e' but " + operators + " or the end"},
                  {"x = 0", 3, "not '=' but " + operators + " or the end"}});
}

TEST(ParseFaults, WhereCallsAndParenthesesAreWrong) {
  expect_columns({{"sin x", 5, "not 'x' but ( after sin"},
                  {"sin", 4, "not the end but ( after sin"},
                  {"sin+1", 4, "not '+' but ( after sin"},
                  {"sin(x,y)", 6, "not ',' but ): sin takes 1 argument"},
                  {"max(x)", 6, "not ')' but a comma: max takes 2 arguments, not 1"},
                  {"max(x,y,x)", 8, "not ',' but ): max takes 2 arguments"},
                  {"(x", 3, "not the end but ) for the ( of column 1"},
                  {"1+(x*(y)", 9, "not the end but ) for the ( of column 3"},
                  {"2*sin(x", 8, "not the end but ) for the ( of column 6"}});
}

TEST(ParseFaults, WhereNumbersAreTooGreatOrTooSmall) {
  expect_columns({{"1e400", 1, "not '1e400' but a number that a double can hold"},
                  {"x+1e-400", 3, "not '1e-400' but a number that a double can hold"}});
}

TEST(ParseFaults, UnknownNamesAreToldTheNearest) {
  const auto nearest = [](const std::string& text, std::size_t column) {
    const Fault fault = formula_fault(text);
    EXPECT_EQ(fault.kind, FaultKind::unknown_name);
    EXPECT_EQ(fault.column, column) << text;
    EXPECT_THAT(fault.allowed, HasSubstr("one of x, y, radius, pi, sqrt"));
    return fault.nearest;
  };
  EXPECT_EQ(nearest("1+sine(x)", 3), "sin");
  EXPECT_EQ(nearest("radiu*2", 1), "radius");
  EXPECT_EQ(nearest("x*Pi", 3), "pi");
  EXPECT_EQ(nearest("xyzzy_plugh", 1), "");
  EXPECT_EQ(nearest("squrt(x)", 1), "sqrt");
}

TEST(ParseFaults, CharactersAreNamedWhole) {
  EXPECT_THAT(formula_fault("x + π").allowed, HasSubstr("at column 5 not 'π' but"));
  EXPECT_THAT(formula_fault("x − y").allowed, HasSubstr("at column 3 not '−' but"));
  EXPECT_THAT(formula_fault("x × y").allowed, HasSubstr("at column 3 not '×' but"));
}

TEST(ParseFaults, NothingIsSkipped) {
  using namespace std::string_literals;
  for (const std::string& text : {"x+\x80y"s, "(\x80x)"s, "x\x80"s, "x*\xBF\xBF 2"s, "\0"s, "x\0"s,
                                  "x+\0y"s, "x\v+y"s, "\xEF\xBB\xBFx"s, "x\xC2\xA0+y"s})
    EXPECT_EQ(formula_faults(text).size(), 1U) << text;
}

TEST(ParseFaults, LongWordsAreCutShort) {
  EXPECT_LT(formula_fault(std::string(4000, 'q')).allowed.size(), 1000U);
  EXPECT_LT(formula_fault("x " + std::string(4000, '1')).allowed.size(), 1000U);
}

// ---- limits ---------------------------------------------------------------------------------

std::string many_times(const std::string& text, std::size_t times) {
  std::string all;
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

TEST(ParseFaults, BytesAreLimited) {
  EXPECT_TRUE(formula_faults("x" + std::string(most_formula_bytes - 1, ' ')).empty());
  const Fault fault = formula_fault("x" + std::string(most_formula_bytes, ' '));
  EXPECT_EQ(fault.kind, FaultKind::limit);
  EXPECT_EQ(fault.column, 1U);
  EXPECT_THAT(fault.allowed, HasSubstr("at most 4096 bytes"));
}

TEST(ParseFaults, DepthIsLimited) {
  for (const std::string open : {"(", "-", "sin(", "x^", "max(1,"}) {
    const bool closes = open.find('(') != std::string::npos;
    const auto nested = [&](std::size_t depth) {
      return many_times(open, depth) + "x" + (closes ? many_times(")", depth) : "");
    };
    EXPECT_TRUE(formula_faults(nested(most_formula_depth)).empty()) << open;
    const Fault fault = formula_fault(nested(most_formula_depth + 1));
    EXPECT_EQ(fault.kind, FaultKind::limit) << open;
    EXPECT_THAT(fault.allowed, HasSubstr("at most 100")) << open;
    EXPECT_EQ(formula_fault(many_times(open, 600)).kind, FaultKind::limit) << open;
  }
}

TEST(ParseFaults, CostIsLimitedWhereverItArises) {
  // Terms that are all unlike, one after the other and one within the other.
  for (const std::string more : {"+exp(x*", "^(x+"}) {
    std::string text = "x";
    int fits = 0;
    for (int i = 1; text.size() < 4000; ++i) {
      text += more + std::to_string(i) + ")";
      Faults faults;
      ProgramBuilder each;
      const int term = read_formula(text, names_and_radius, {}, each, faults);
      if (term < 0) {
        EXPECT_EQ(faults.list().front().kind, FaultKind::limit);
        break;
      }
      ++fits;
      ASSERT_LE(each.program({term}).cost, most_formula_cost) << text;
    }
    EXPECT_GT(fits, 50);
  }
}

TEST(ParseFaults, GarbageIsReadOrHasOneFault) {
  static const std::vector<std::string> words{
      "x",     "y",        "1",     "2.5",    "1e3", "1e999",
      ".",     "e",        "pi",    "radius", "+",   "-",
      "*",     "/",        "^",     "(",      ")",   ",",
      "sin",   "sin(",     "max(",  "atan2(", " ",   "\t",
      "q",     "\xCF\x80", "\x80",  "\xFF",   "$",   std::string(1, '\0'),
      "(((((", ")))))",    "-----", "x^",     "0",   "sqrt("};
  Random random(1);
  int read = 0, refused = 0;
  for (int i = 0; i < 100'000; ++i) {
    std::string text;
    const int length = random.below(12);
    // Half of the texts only of words that formulas are made of.
    const int choice = random.chance(0.5) ? 18 : static_cast<int>(words.size());
    for (int k = 0; k < length; ++k) text += words[static_cast<std::size_t>(random.below(choice))];
    const std::vector<Fault> faults = formula_faults(text);
    ASSERT_LE(faults.size(), 1U) << text;
    ++(faults.empty() ? read : refused);
    if (faults.empty()) continue;
    ASSERT_TRUE(faults[0].column.has_value());
    ASSERT_GE(*faults[0].column, 1U) << text;
    ASSERT_LE(*faults[0].column, text.size() + 1) << text;
  }
  EXPECT_GT(read, 2'000);
  EXPECT_GT(refused, 50'000);
}

TEST(ParseFaults, RandomBytesAreReadOrHaveOneFault) {
  Random random(2);
  for (int i = 0; i < 20'000; ++i) {
    std::string text(static_cast<std::size_t>(random.below(40)), ' ');
    for (char& each : text) each = static_cast<char>(random.below(256));
    const std::vector<Fault> faults = formula_faults(text);
    ASSERT_LE(faults.size(), 1U);
    for (const Fault& fault : faults) ASSERT_LE(*fault.column, text.size() + 1);
  }
}

TEST(ParseFaults, ThousandsOfOpenThingsAreRefused) {
  for (const std::string each : {"(", "-", "x^", "sin(", ")", ",", "^", "x+", "max(x,"})
    EXPECT_EQ(formula_faults(many_times(each, most_formula_bytes / each.size())).size(), 1U)
        << each;
}

}  // namespace
}  // namespace tia
