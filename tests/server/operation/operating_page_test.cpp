// server/OPERATING.md: every test that it names is there, and every option has the default it says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

#include "server/operation/config.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::string& page() {
  static const std::string text = text_of(fs::path(TIA_SOURCE_DIR) / "server/OPERATING.md");
  return text;
}

// What a pattern's first group and, where it has one, second group find.
std::set<std::string> found(const std::string& text, const std::string& pattern,
                            const std::string& between = "") {
  std::set<std::string> all;
  const std::regex regex(pattern);
  for (std::sregex_iterator i(text.begin(), text.end(), regex), end; i != end; ++i)
    all.insert(i->size() > 2 ? (*i)[1].str() + between + (*i)[2].str() : (*i)[1].str());
  return all;
}

std::set<std::string> names_of_tests() {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(TIA_SOURCE_DIR) / "tests"))
    if (entry.path().extension() == ".cpp")
      names.merge(found(text_of(entry.path()), R"(TEST(?:_[FP])?\((\w+),\s*(\w+)\))", "."));
  return names;
}

TEST(OperatingPage, NamesTestsThatExist) {
  const auto named = found(page(), R"(`(\w+\.\w+)`)");
  EXPECT_GT(named.size(), 40U);
  const auto existing = names_of_tests();
  for (const std::string& name : named)
    EXPECT_TRUE(existing.contains(name) || name == "limits.py") << name;
}

TEST(OperatingPage, SaysWhatOptionsAreByDefault) {
  std::map<std::string, std::string> defaults;
  for (const auto& row : server::option_rows()) defaults[row.variable] = row.value;
  const std::regex option(R"(\| `(TIA_\w+)` ?([0-9a-z]*) \|)");
  int compared = 0;
  for (std::sregex_iterator i(page().begin(), page().end(), option), end; i != end; ++i) {
    const std::string name = (*i)[1], told = (*i)[2];
    ASSERT_TRUE(defaults.contains(name)) << name;
    if (told.empty()) continue;  // the machine's own
    EXPECT_EQ(told == "none" ? "" : told, defaults[name]) << name;
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

// Whatever bounds something is on the page: all options but where to listen and how to end.
TEST(OperatingPage, HasEveryOptionThatBounds) {
  const std::set<std::string> others{"TIA_HOST", "TIA_PORT", "TIA_DRAIN_MS", "TIA_DRAIN_DELAY_MS"};
  for (const auto& row : server::option_rows())
    EXPECT_TRUE(page().find('`' + row.variable + '`') != std::string::npos ||
                others.contains(row.variable))
        << row.variable;
}

// Every row of a table ends with a test.
TEST(OperatingPage, HasATestInEveryRow) {
  std::istringstream lines(page());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| ") || line.starts_with("| what |")) continue;
    EXPECT_TRUE(std::regex_search(line, std::regex(R"(`\w+\.\w+` \|$)"))) << line;
  }
}

}  // namespace
}  // namespace tia::test
