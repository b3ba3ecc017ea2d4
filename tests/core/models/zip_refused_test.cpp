// Archives that no packer makes.
#include "core/models/zip.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/core/models/zip_reading.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::expect_zip_broken;
using test::expect_zip_item_refused;
using test::expect_zip_refused;
using test::four_corners;
using test::small_zip;
using test::small_zip_files;
using test::unzipped;
using test::zip_item;
using test::zip_of;
using test::ZipFiles;
using test::ZipItem;
using test::ZipShape;

// ---- files that are refused ---------------------------------------------------------------------

TEST(ZipRefused, PathsThatLeadOutAreRefused) {
  for (const auto& [name, pointer] : std::map<std::string, std::string>{
           {"../a", "/..~1a"}, {"b/../../a", "/b~1..~1..~1a"}, {"b\\..\\a", "/b\\..\\a"}})
    expect_zip_item_refused(zip_item(name, "v"), pointer, "without \"..\"");
  for (const auto& [name, pointer] :
       std::map<std::string, std::string>{{"/etc/a", "/~1etc~1a"},
                                          {"\\\\host\\a", "/\\\\host\\a"},
                                          {"C:\\a", "/C:\\a"},
                                          {"c:a", "/c:a"}})
    expect_zip_item_refused(zip_item(name, "v"), pointer, "a relative path");
  expect_zip_item_refused(zip_item("", "v"), "/", "names a file");
  expect_zip_item_refused(zip_item("a\n", "v"), "/a\n", "control");
  expect_zip_item_refused(zip_item(std::string("a\0b", 3), "v"), std::string("/a\0b", 4),
                          "control");
  expect_zip_item_refused(zip_item("\x82.png", "v"), "/\x82.png", "UTF-8");
}

TEST(ZipRefused, PathsThatComeTwiceAreRefused) {
  const auto twice = [](const char* one, const char* other) {
    expect_zip_refused(zip_of({zip_item(one, "1"), zip_item("b", "2"), zip_item(other, "1")}),
                       {{FaultKind::conflict, "/a~1c", "\"a/c\"", "each path once"}});
  };
  twice("a/c", "a/c");
  twice("a/c", "a\\c");
  twice("a/c", "./a//c");
}

TEST(ZipRefused, KindsOfFilesThatAreNotReadAreRefused) {
  for (const unsigned flag : {0x1U, 0x41U, 0x2000U}) {
    ZipItem item = zip_item("x", "v");
    item.local.flags = item.central.flags = flag;
    expect_zip_item_refused(item, "/x", "not encrypted");
  }
  for (const unsigned method : {1U, 9U, 12U, 14U, 93U, 99U}) {
    ZipItem item = zip_item("x", "v");
    item.local.method = item.central.method = method;
    expect_zip_item_refused(item, "/x", "stored or deflated");
  }
  ZipItem link = zip_item("x", "/etc/passwd", false);
  link.attributes = std::uint64_t{0120777} << 16U;
  expect_zip_item_refused(link, "/x", "symbolic link");
  link.made_by = 0x0014;  // DOS: the bits mean something else
  EXPECT_EQ(unzipped(zip_of({link})).size(), 1U);
  ZipItem elsewhere = zip_item("x", "v");
  elsewhere.disk = 1;
  expect_zip_item_refused(elsewhere, "/x", "first disk");
}

TEST(ZipRefused, HeadersThatContradictTheDirectoryAreRefused) {
  const std::vector<void (*)(ZipItem&)> lies{
      [](ZipItem& item) { item.local.name = "y"; },
      [](ZipItem& item) { item.local.name = "xx"; },
      [](ZipItem& item) { item.local.method = 0; },
      [](ZipItem& item) { item.local.flags = 1; },
      [](ZipItem& item) { ++item.local.crc; },
      [](ZipItem& item) { ++item.local.packed; },
      [](ZipItem& item) { --item.local.unpacked; },
      [](ZipItem& item) { item.local.crc = 0; },
      [](ZipItem& item) { item.local.packed = 0xFFFFFFFF; },
      [](ZipItem& item) { item.local.flags = 8, item.local.unpacked = 1; },
      [](ZipItem& item) { item.at = 0; },
      [](ZipItem& item) { item.at = 1; },
      [](ZipItem& item) { item.at = 0xFFFFFFFE; },
      [](ZipItem& item) { item.local.packed = item.central.packed = 0x7FFFFFFF; },
  };
  for (std::size_t i = 0; i < lies.size(); ++i) {
    SCOPED_TRACE(i);
    ZipItem item = zip_item("x", four_corners);
    lies[i](item);
    expect_zip_item_refused(item, "/x", "says what the directory says");
  }
}

TEST(ZipRefused, NumbersOfAllOnesNeedTheirField) {
  ZipItem item = zip_item("x", four_corners);
  item.at = 0xFFFFFFFF;
  expect_zip_item_refused(item, "/x", "ZIP64");
  item = zip_item("x", four_corners);
  item.central.unpacked = 0xFFFFFFFF;
  expect_zip_item_refused(item, "/x", "ZIP64");
  item.central.extra = test::zip_bytes(1, 2) + test::zip_bytes(7, 2) + test::zip_bytes(0, 7);
  expect_zip_item_refused(item, "/x", "ZIP64");
  item.central.extra = test::zip_bytes(1, 2) + test::zip_bytes(8, 2) + test::zip_bytes(0, 7);
  expect_zip_item_refused(item, "/x", "ZIP64");
}

TEST(ZipRefused, BytesThatDoNotUnpackToWhatIsSaidAreRefused) {
  const auto damaged = [](const char* got, void (*damage)(ZipItem&)) {
    ZipItem item = zip_item("x", four_corners);
    damage(item);
    expect_zip_refused(zip_of({zip_item("a", "v"), item}), {{FaultKind::malformed, "/x", got, ""}});
  };
  const char* const not_unpacked = "\"bytes that do not unpack to its size\"";
  damaged(not_unpacked, [](ZipItem& item) { --item.local.unpacked, --item.central.unpacked; });
  damaged(not_unpacked, [](ZipItem& item) { ++item.local.unpacked, ++item.central.unpacked; });
  damaged(not_unpacked, [](ZipItem& item) {
    item.data += '\0';
    ++item.local.packed, ++item.central.packed;
  });
  damaged(not_unpacked, [](ZipItem& item) { item.data[0] = '\x07'; });
  damaged("\"bytes of another CRC-32\"",
          [](ZipItem& item) { ++item.local.crc, ++item.central.crc; });
  ZipItem stored = zip_item("x", "abc", false);
  stored.data = "abd";
  expect_zip_refused(zip_of({stored}),
                     {{FaultKind::malformed, "/x", "\"bytes of another CRC-32\"", ""}});
  ZipItem two_sizes = zip_item("x", "abc", false);
  two_sizes.local.unpacked = two_sizes.central.unpacked = 2;
  expect_zip_item_refused(two_sizes, "/x", "one size");
}

// Fifield's bomb: many entries of the directory that are one file, or files in each other's bytes.
TEST(ZipRefused, FilesThatShareBytesAreRefused) {
  const ZipItem one = zip_item("x", four_corners);
  const std::string archive = zip_of({one});
  // A stored file whose bytes are another file with its header, behind 30 bytes and a name of 5.
  const ZipItem outer = zip_item("outer", archive.substr(0, archive.find("PK\x01\x02")), false);
  ZipItem inner = one;
  inner.at = 30 + 5;
  expect_zip_refused(zip_of({outer, inner}),
                     {{FaultKind::malformed, "/x", "\"x\"", "shares no bytes"}});
  ZipItem same = one;
  same.at = 0;
  expect_zip_refused(zip_of({one, same}), {{FaultKind::malformed, "/x", "\"x\"", "shares no bytes"},
                                           {FaultKind::conflict, "/x", "\"x\"", "each path once"}});
}

TEST(ZipRefused, BytesThatReachIntoTheDirectoryAreRefused) {
  ZipItem item = zip_item("x", "abc", false);
  item.local.packed = item.local.unpacked = item.central.packed = item.central.unpacked = 4;
  expect_zip_item_refused(item, "/x", "and the bytes");
}

// ---- archives that are none ---------------------------------------------------------------------

TEST(ZipRefused, EndRecordsThatLieAreRefused) {
  const std::vector<ZipItem> items{zip_item("a.obj", four_corners), zip_item("b", "b")};
  const auto size = static_cast<std::uint64_t>(2 * 46 + 5 + 1);
  const std::uint64_t at = zip_of(items).size() - 22 - size;
  const auto lie = [&](const char* got, void (*change)(ZipShape&, std::uint64_t, std::uint64_t)) {
    ZipShape shape;
    change(shape, size, at);
    expect_zip_broken(zip_of(items, shape), got);
  };
  lie("more in it than it counts", [](ZipShape& s, auto, auto) { s.entries = 1; });
  lie("breaks off in its entry 2", [](ZipShape& s, auto, auto) { s.entries = 3; });
  lie("breaks off in its entry 2", [](ZipShape& s, auto, auto) { s.entries = 0xFFFF; });
  lie("several disks", [](ZipShape& s, auto, auto) { s.here = 1; });
  lie("several disks", [](ZipShape& s, auto, auto) { s.disk = 1; });
  lie("several disks", [](ZipShape& s, auto, auto) { s.directory_disk = 0xFFFF; });
  lie("another place", [](ZipShape& s, auto z, auto) { s.size = z - 1; });
  lie("another place", [](ZipShape& s, auto z, auto) { s.size = z + 1; });
  lie("another place", [](ZipShape& s, auto, auto) { s.size = 0xFFFFFFFF; });
  lie("another place", [](ZipShape& s, auto, auto a) { s.at = a + 1; });
  lie("another place", [](ZipShape& s, auto, auto) { s.at = 0xFFFFFFFF; });
  lie("breaks off in its entry 0", [](ZipShape& s, auto z, auto a) {
    s.at = a + 1;
    s.size = z - 1;
  });
  lie("no end record", [](ZipShape& s, auto, auto) { s.comment_size = 1; });
  lie("no end record", [](ZipShape& s, auto, auto) {
    s.comment = "abc";
    s.comment_size = 2;
  });
  lie("another place", [](ZipShape& s, auto, auto) { s.before_end = "gap"; });
}

TEST(ZipRefused, RecordsThatBreakOffInLocatorsAreRefused) {
  const std::string locator = "PK\x06\x07" + std::string(16, '\0');
  ZipShape shape;
  shape.before_end = locator;
  expect_zip_broken(zip_of({}, shape), "no end record");
  expect_zip_broken(zip_of({zip_item("a", std::string(100, 'a'), false)}, shape), "no end record");
}

TEST(ZipRefused, BytesThatAreNoArchiveAreRefused) {
  expect_zip_broken("", "no end record");
  expect_zip_broken("PK\x03\x04", "no end record");
  expect_zip_broken(std::string(100'000, 'P'), "no end record");
  expect_zip_broken(small_zip() + "\n", "no end record");
  expect_zip_broken(small_zip() + std::string(70'000, ' '), "no end record");
  expect_zip_broken("MZ" + small_zip(), "another place");
}

TEST(ZipRefused, CutAnywhereItIsRefused) {
  const std::string archive = small_zip();
  for (std::size_t size = 0; size < archive.size(); ++size) {
    Faults faults;
    ASSERT_EQ(unzipped(archive.substr(0, size), faults), ZipFiles()) << size;
    ASSERT_FALSE(faults.empty()) << size;
  }
}

TEST(ZipRefused, AnyOneBitThatIsWrongGivesAFaultOrTheSameFiles) {
  const std::string archive = small_zip();
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * archive.size(); ++bit) {
    std::string wrong = archive;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ 1 << bit % 8);
    Faults faults;
    const ZipFiles files = unzipped(wrong, faults);
    ASSERT_EQ(files, faults.empty() ? small_zip_files : ZipFiles()) << bit;
    refused += faults.empty() ? 0 : 1;
  }
  EXPECT_GT(refused, static_cast<int>(4 * archive.size()))
      << "of dates and the like there are fewer";
}

TEST(ZipRefused, SomeBitsThatAreWrongGiveAFaultOrTheSameFiles) {
  const std::string archive = small_zip();
  test::Random random(9310);
  for (int i = 0; i < 2000; ++i) {
    std::string wrong = archive;
    for (int flips = random.whole(1, 4); flips > 0; --flips) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(wrong.size())));
      wrong[at] = static_cast<char>(wrong[at] ^ 1 << random.below(8));
    }
    Faults faults;
    const ZipFiles files = unzipped(wrong, faults);
    ASSERT_EQ(files, faults.empty() ? small_zip_files : ZipFiles()) << i;
  }
}

}  // namespace
}  // namespace tia
