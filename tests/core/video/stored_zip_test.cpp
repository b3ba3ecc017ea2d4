// Archives that are written piece by piece, read by the tracer's own reader of ZIP and, where they
// are large, field by field.
#include "core/video/stored_zip.h"

#include <gtest/gtest.h>

#include "core/models/zip.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

std::string archive_of(StoredZip& zip) {
  std::string archive = zip.file("film.json", "{}");
  archive += zip.file("00000.png", std::string("\x89PNG\0\xFF", 6));
  return archive += zip.end();
}

std::uint64_t low_first(const std::string& text, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes; i-- > 0;)
    value = value << 8U | static_cast<unsigned char>(text.at(at + i));
  return value;
}

TEST(StoredZip, HoldsItsFiles) {
  StoredZip zip;
  const std::string archive = archive_of(zip);
  Faults faults;
  const auto files = unpack_zip(
      {reinterpret_cast<const std::uint8_t*>(archive.data()), archive.size()}, {}, faults);
  faults.raise();
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "film.json");
  EXPECT_EQ(std::string(files[0].bytes.begin(), files[0].bytes.end()), "{}");
  EXPECT_EQ(files[1].path, "00000.png");
  EXPECT_EQ(files[1].bytes, (std::vector<std::uint8_t>{0x89, 'P', 'N', 'G', 0, 0xFF}));
}

// Source: APPNOTE 6.3.10, 4.3.14 to 4.3.16 and 4.5.3.
TEST(StoredZip, ThatIsLongTellsItsPlacesInZip64) {
  const std::uint64_t before = std::uint64_t{5} << 30U;
  StoredZip zip(before);
  const std::string archive = archive_of(zip);
  const std::string end = archive.substr(archive.rfind("PK\5\6"));
  EXPECT_EQ(low_first(end, 16, 4), 0xFFFFFFFF);
  EXPECT_EQ(low_first(end, 10, 2), 2U);
  const std::size_t locator = archive.rfind("PK\6\7"), record = archive.rfind("PK\6\6");
  EXPECT_EQ(low_first(archive, locator + 8, 8), before + record);
  const std::size_t directory = archive.find("PK\1\2");
  EXPECT_EQ(low_first(archive, record + 48, 8), before + directory);
  EXPECT_EQ(low_first(archive, record + 40, 8), record - directory);
  const std::size_t second = archive.rfind("PK\1\2"), file = archive.rfind("PK\3\4");
  EXPECT_EQ(low_first(archive, second + 42, 4), 0xFFFFFFFF);
  EXPECT_EQ(low_first(archive, second + 46 + 9, 2), 1U);
  EXPECT_EQ(low_first(archive, second + 46 + 9 + 4, 8), before + file);
}

}  // namespace
}  // namespace tia::test
