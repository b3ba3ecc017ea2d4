// What the builder of programs shares, folds and reuses.
#include <gtest/gtest.h>

#include "tests/core/formulas/values.h"

namespace tia {
namespace {

using test::Random;

Program program_of_all(const std::vector<std::string_view>& texts) {
  return program_of(texts, {test::variable_names, {}});
}
std::size_t instructions(std::string_view text) {
  return program_of_all({text}).instructions.size();
}

TEST(ProgramBuilder, LikeTermsAreOne) {
  EXPECT_EQ(instructions("x+y"), 3U);
  EXPECT_EQ(instructions("(x+y)*sin(x+y)"), 5U);
  EXPECT_EQ(instructions("x*x"), instructions("x^2"));
  EXPECT_EQ(program_of_all({"x+y", "x+y"}).instructions.size(), 3U);
}

TEST(ProgramBuilder, ConstantsAreComputedOnce) {
  EXPECT_EQ(instructions("2*3+sin(1)^2-4/5"), 1U);
  EXPECT_EQ(instructions("-3"), 1U);
  EXPECT_EQ(instructions("x+(2-2)"), 3U);
}

TEST(ProgramBuilder, FoldedConstantsAreThoseThatTheProgramComputes) {
  Random random(1);
  const auto all = [&](const std::string& text, const std::array<double, 2>& with) {
    const std::array<double, 3> at{with[0], with[1], 0};
    const Program late = program_of_all({text});
    const Program early = program_of({text}, {{"z"}, {{"x", with[0]}, {"y", with[1]}}});
    const double expected = evaluate(late, at.data()), got = evaluate(early, at.data());
    EXPECT_TRUE(got == expected || (std::isnan(got) && std::isnan(expected))) << text;
    EXPECT_TRUE(!std::isfinite(expected) || early.instructions.size() == 1) << text;
  };
  for (int i = 0; i < 200; ++i) {
    const std::array<double, 2> with{random.in(-2, 2), random.in(-2, 2)};
    for (const char* text : {"x+y", "x-y", "x*y", "x/y", "x^y", "abs(x)^y", "-x", "x^7", "x^-3"})
      all(text, with);
    for (const char* name : {"sqrt", "abs", "floor", "exp", "log", "sin", "cos", "tan", "asin",
                             "acos", "atan", "sinh", "cosh", "tanh"})
      all(std::string(name) + "(x)", with);
    for (const char* name : {"min", "max", "atan2"}) all(std::string(name) + "(x, y)", with);
  }
}

TEST(ProgramBuilder, UndefinedConstantsStayUndefined) {
  for (const char* text : {"sqrt(-1)", "log(-1)", "asin(2)", "(-8)^(1/3)", "min(sqrt(-1), 2)"}) {
    const Program program = program_of_all({text});
    EXPECT_TRUE(std::isnan(evaluate<double>(program, nullptr))) << text;
    Definedness<double> where;
    evaluate<Interval<double>>(program, nullptr, where);
    EXPECT_FALSE(where.whole) << text;
    EXPECT_FALSE(where.some) << text;
  }
}

TEST(ProgramBuilder, TermsThatNoResultNeedsAreLeftOut) {
  ProgramBuilder builder;
  const int x = builder.variable(0);
  builder.operation(Op::exp, builder.operation(Op::sin, x));
  const int result = builder.operation(Op::negate, x);
  const Program program = builder.program({result});
  EXPECT_EQ(program.instructions.size(), 2U);
  EXPECT_EQ(program.cost, cost_of(Op::variable) + cost_of(Op::negate));
  const double at = 3;
  EXPECT_EQ(evaluate(program, &at), -3);
}

TEST(ProgramBuilder, LongSumsNeedFewSlots) {
  std::string text = "x";
  double expected = 0.5;
  for (int i = 1; i < 300; ++i) {
    text += "+x*" + std::to_string(i);
    expected += 0.5 * i;
  }
  const Program program = program_of_all({text});
  const double at = 0.5;
  EXPECT_EQ(evaluate(program, &at), expected);
  EXPECT_LE(program.slots, 6U);
}

TEST(ProgramBuilder, SeveralResultsKeepTheirSlots) {
  Random random(2);
  for (int i = 0; i < 1'000; ++i) {
    std::vector<std::string> texts;
    std::vector<test::TreePtr> trees;
    for (int k = 0; k < 3; ++k) {
      trees.push_back(test::any_tree(random, random.below(4)));
      texts.push_back(print(*trees.back(), random).text);
    }
    const Program program = program_of_all({texts[0], texts[1], texts[2]});
    const std::array<double, 3> at{0.3, 0.7, 1.1};
    Anywhere where;
    const double* const slots = run(program, at.data(), where);
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = test::Evaluation<double>(at).value(*trees[k]);
      const double got = slots[program.results[k]];
      ASSERT_TRUE(got == expected || (std::isnan(got) && std::isnan(expected))) << texts[k];
    }
  }
}

TEST(ProgramBuilder, CostIsThatOfItsInstructions) {
  const Program program = program_of_all({"sin(x)+x^y"});
  EXPECT_EQ(program.cost, cost_of(Op::sin) + cost_of(Op::pow) + 3);
}

}  // namespace
}  // namespace tia
