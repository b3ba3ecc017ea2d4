// Words, lines and numbers in the texts of models.
#include "core/models/text_words.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace tia {
namespace {

TEST(TextWords, AreCutOffOneByOne) {
  std::string_view text = " \ta bc\r\n d";
  EXPECT_EQ(cut_word(text), "a");
  EXPECT_EQ(cut_word(text), "bc");
  EXPECT_EQ(cut_word(text), "d");
  EXPECT_EQ(cut_word(text), "");
  EXPECT_EQ(trimmed(" \r a b\t"), "a b");
  EXPECT_EQ(trimmed(" \n"), "");
  EXPECT_TRUE(is_word("EndSolid", "endsolid"));
  EXPECT_FALSE(is_word("end", "endsolid"));
  EXPECT_FALSE(is_word("endsolids", "endsolid"));
}

TEST(TextWords, LinesAreCutOffWithTheirEnds) {
  std::string_view text = "a\n\nb c";
  EXPECT_EQ(cut_line(text, '\n'), "a");
  EXPECT_EQ(cut_line(text, '\n'), "");
  EXPECT_EQ(cut_line(text, '\n'), "b c");
  EXPECT_TRUE(text.empty());
}

TEST(TextWords, NumbersAreTheNearestDoubles) {
  EXPECT_EQ(number_in("+0.1"), 0.1);
  EXPECT_EQ(number_in("-.5E+1"), -5.0);
  EXPECT_EQ(number_in("5."), 5.0);
  EXPECT_EQ(number_in("9007199254740993"), 9007199254740992.0);
  EXPECT_EQ(number_in("1e-400"), 0.0);
  EXPECT_EQ(number_in("-1e-400"), 0.0);
  EXPECT_EQ(number_in("4.9e-324"), std::numeric_limits<double>::denorm_min());
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(number_in("1e400"), infinite);
  EXPECT_EQ(number_in("-1e400"), -infinite);
  EXPECT_EQ(number_in("1" + std::string(400, '0') + "e-10"), infinite);
  EXPECT_EQ(number_in("inf"), infinite);
  EXPECT_TRUE(std::isnan(number_in("nan").value()));
  for (const char* word : {"", "+", "-", "+-1", "++1", "1x", "0x1", "1,5", "e5", "1e", "1.#IND"})
    EXPECT_FALSE(number_in(word)) << word;
}

TEST(TextWords, NumbersThatJsonHasNotAreShownAsWords) {
  EXPECT_EQ(shown_number(0.5), Value(0.5));
  EXPECT_EQ(shown_number(std::nan("")), Value("nan"));
  EXPECT_EQ(shown_number(-std::numeric_limits<double>::infinity()), Value("-inf"));
}

}  // namespace
}  // namespace tia
