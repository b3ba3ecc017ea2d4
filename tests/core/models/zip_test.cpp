// Archives as packers make them, and how much is unpacked of them.
#include "core/models/zip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "core/input/base64.h"
#include "tests/core/models/file_bytes.h"
#include "tests/core/models/zip_reading.h"

namespace tia {
namespace {

using test::expect_zip_broken;
using test::expect_zip_item_refused;
using test::expect_zip_refused;
using test::file_bytes;
using test::four_corners;
using test::small_zip;
using test::small_zip_files;
using test::unzipped;
using test::zip_item;
using test::zip_of;
using test::ZipFiles;
using test::ZipItem;
using test::ZipShape;

std::string decoded(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  if (decode_base64(text, bytes)) throw std::runtime_error("no base64");
  return {bytes.begin(), bytes.end()};
}

// ---- what packers make --------------------------------------------------------------------------

TEST(Zip, IsKnownByItsFirstBytes) {
  EXPECT_TRUE(is_zip(file_bytes(small_zip())));
  EXPECT_FALSE(is_zip(file_bytes("PK\x05\x06")));
  EXPECT_FALSE(is_zip(file_bytes("PK\x03")));
  EXPECT_FALSE(is_zip({}));
}

TEST(Zip, FilesComeOutInTheDirectorysOrder) {
  EXPECT_EQ(unzipped(small_zip()), small_zip_files);
  EXPECT_EQ(unzipped(zip_of({})), ZipFiles());
}

// One folder as three programs pack it: Info-ZIP 3.0 (`zip -rX`), which says nothing of UTF-8; Java
// (`jar -cM`), with data descriptors; Python's zipfile with force_zip64, whose local sizes are all
// ones.
TEST(Zip, ArchivesOfThreePackersHoldTheSameFiles) {
  const std::string info =
      "UEsDBAoAAAAAAIMYIlgAAAAAAAAAAAAAAAAGAAAAY2hhaXIvUEsDBAoAAAAAAIMYIliDFtyMAQAAAAEAAAAMAAAAY2hh"
      "aXIvw6kucG5neFBLAwQKAAAAAACDGCJYAAAAAAAAAAAAAAAADwAAAGNoYWlyL2VtcHR5LmJpblBLAwQUAAAACACDGCJY"
      "KqggkAoAAAAgAAAADwAAAGNoYWlyL2NoYWlyLm9iaitTMABBrjIcNABQSwECHgMKAAAAAACDGCJYAAAAAAAAAAAAAAAA"
      "BgAAAAAAAAAAABAA7UEAAAAAY2hhaXIvUEsBAh4DCgAAAAAAgxgiWIMW3IwBAAAAAQAAAAwAAAAAAAAAAQAAAKSBJAAA"
      "AGNoYWlyL8OpLnBuZ1BLAQIeAwoAAAAAAIMYIlgAAAAAAAAAAAAAAAAPAAAAAAAAAAAAAACkgU8AAABjaGFpci9lbXB0"
      "eS5iaW5QSwECHgMUAAAACACDGCJYKqggkAoAAAAgAAAADwAAAAAAAAABAAAApIF8AAAAY2hhaXIvY2hhaXIub2JqUEsF"
      "BgAAAAAEAAQA6AAAALMAAAAAAA==";
  const std::string java =
      "UEsDBAoAAAgAAIMYIlgAAAAAAAAAAAAAAAAGAAQAY2hhaXIv/soAAFBLAwQUAAgICACDGCJYAAAAAAAAAAAAAAAADwAA"
      "AGNoYWlyL2NoYWlyLm9iaitTMABBrjIcNABQSwcIKqggkAoAAAAgAAAAUEsDBAoAAAgAAIMYIlgAAAAAAAAAAAAAAAAP"
      "AAAAY2hhaXIvZW1wdHkuYmluUEsDBBQACAgIAIMYIlgAAAAAAAAAAAAAAAAMAAAAY2hhaXIvw6kucG5nqwAAUEsHCIMW"
      "3IwDAAAAAQAAAFBLAQIKAAoAAAgAAIMYIlgAAAAAAAAAAAAAAAAGAAQAAAAAAAAAAAAAAAAAAABjaGFpci/+ygAAUEsB"
      "AhQAFAAICAgAgxgiWCqoIJAKAAAAIAAAAA8AAAAAAAAAAAAAAAAAKAAAAGNoYWlyL2NoYWlyLm9ialBLAQIKAAoAAAgA"
      "AIMYIlgAAAAAAAAAAAAAAAAPAAAAAAAAAAAAAAAAAG8AAABjaGFpci9lbXB0eS5iaW5QSwECFAAUAAgICACDGCJYgxbc"
      "jAMAAAABAAAADAAAAAAAAAAAAAAAAACcAAAAY2hhaXIvw6kucG5nUEsFBgAAAAAEAAQA7AAAANkAAAAAAA==";
  const std::string python =
      "UEsDBC0AAAAIAIMYIlgqqCCQ//////////8PABQAY2hhaXIvY2hhaXIub2JqAQAQACAAAAAAAAAACgAAAAAAAAArUzAA"
      "Qa4yHDQAUEsDBC0AAAgIAIMYIliDFtyM//////////8MABQAY2hhaXIvw6kucG5nAQAQAAEAAAAAAAAAAwAAAAAAAACr"
      "AABQSwMELQAAAAgAgxgiWAAAAAD//////////w8AFABjaGFpci9lbXB0eS5iaW4BABAAAAAAAAAAAAACAAAAAAAAAAMA"
      "UEsBAi0DLQAAAAgAgxgiWCqoIJAKAAAAIAAAAA8AAAAAAAAAAAAAAIABAAAAAGNoYWlyL2NoYWlyLm9ialBLAQItAy0A"
      "AAgIAIMYIliDFtyMAwAAAAEAAAAMAAAAAAAAAAAAAACAAUsAAABjaGFpci/DqS5wbmdQSwECLQMtAAAACACDGCJYAAAA"
      "AAIAAAAAAAAADwAAAAAAAAAAAAAAgAGMAAAAY2hhaXIvZW1wdHkuYmluUEsFBgAAAAADAAMAtAAAAM8AAAAAAA==";
  const ZipFiles chair{
      {"chair/chair.obj", four_corners}, {"chair/empty.bin", ""}, {"chair/é.png", "x"}};
  for (const std::string& archive : {info, java, python}) {
    ZipFiles files = unzipped(decoded(archive));
    std::ranges::sort(files);
    EXPECT_EQ(files, chair);
  }
}

// `cat chair.obj | zip`: ZIP64's end record, which says what the end record says.
TEST(Zip, AnEndRecordOfZip64ThatIsNotNeededIsTaken) {
  const std::string archive = decoded(
      "UEsDBC0AAAAIAFMIe10qqCCQ//////////8BABQALQEAEAAgAAAAAAAAAAoAAAAAAAAAK1MwAEGuMhw0AFBLAQIeAy0A"
      "AAAIAFMIe10qqCCQCgAAACAAAAABAAAAAAAAAAEAAACAEQAAAAAtUEsGBiwAAAAAAAAAHgMtAAAAAAAAAAAAAQAAAAAA"
      "AAABAAAAAAAAAC8AAAAAAAAAPQAAAAAAAABQSwYHAAAAAGwAAAAAAAAAAQAAAFBLBQYAAAAAAQABAC8AAAA9AAAAAAA"
      "=");
  EXPECT_EQ(unzipped(archive), (ZipFiles{{"-", four_corners}}));
  for (const std::size_t lie : {32U, 40U, 48U}) {  // of the record, which begins at 0x6C
    std::string other = archive;
    other[0x6C + lie] ^= 1;
    expect_zip_broken(other, "no end record");
  }
}

TEST(Zip, NumbersMayStandInZip64Fields) {
  ZipItem item = zip_item("b.obj", four_corners);
  const std::uint64_t at = zip_of({zip_item("a.obj", "v")}).find("PK\x01\x02");
  item.central.extra = "UT" + test::zip_bytes(1, 2) + "." + test::zip_bytes(1, 2) +
                       test::zip_bytes(24, 2) + test::zip_bytes(item.central.unpacked, 8) +
                       test::zip_bytes(item.central.packed, 8) + test::zip_bytes(at, 8);
  item.central.unpacked = item.central.packed = 0xFFFFFFFF;
  item.at = 0xFFFFFFFF;
  EXPECT_EQ(unzipped(zip_of({zip_item("a.obj", "v"), item})),
            (ZipFiles{{"a.obj", "v"}, {"b.obj", four_corners}}));
  item.local.flags = 8;  // so that its sizes contradict nothing
  item.local.packed = item.local.unpacked = 0;
  item.central.extra[item.central.extra.size() - 11] = 1;  // 2^40 bytes packed
  expect_zip_item_refused(item, "/b.obj", "and the bytes");
}

TEST(Zip, SizesMayFollowTheBytes) {
  for (const std::uint64_t size : {std::uint64_t{0}, std::uint64_t{0xFFFFFFFF}}) {
    ZipItem item = zip_item("a.obj", four_corners);
    item.local.crc = 0;
    item.local.packed = item.local.unpacked = size;
    item.local.flags = item.central.flags = 8;
    item.behind = "PK\x07\x08" + test::zip_bytes(item.central.crc, 4) +
                  test::zip_bytes(item.central.packed, 4) +
                  test::zip_bytes(item.central.unpacked, 4);
    EXPECT_EQ(unzipped(zip_of({item, zip_item("b", "b")})),
              (ZipFiles{{"a.obj", four_corners}, {"b", "b"}}));
  }
}

TEST(Zip, FoldersAndWhatMacosAddsArePassedOver) {
  EXPECT_EQ(unzipped(zip_of({zip_item("chair/", "", false), zip_item("win\\", "", false),
                             zip_item("chair/.DS_Store", "x"), zip_item("chair/a.obj", "v"),
                             zip_item("__MACOSX/chair/._a.obj", "x"), zip_item(".DS_Store", "x")})),
            (ZipFiles{{"chair/a.obj", "v"}}));
}

TEST(Zip, PathsAreCleaned) {
  EXPECT_EQ(unzipped(zip_of({zip_item("chair\\parts\\a.obj", "v"), zip_item("./b//c.mtl", "m")})),
            (ZipFiles{{"chair/parts/a.obj", "v"}, {"b/c.mtl", "m"}}));
}

TEST(Zip, CommentsMayStandAtTheEndAndWithFiles) {
  ZipItem item = zip_item("a.obj", "v");
  item.comment = "a chair";
  // The last record whose comment ends the archive counts, whatever the comment holds.
  for (const std::string& comment :
       {std::string("by hand"), std::string(65'535, 'x'),
        std::string("PK\x05\x06 and more of it, up to a whole record")}) {
    ZipShape shape;
    shape.comment = comment;
    EXPECT_EQ(unzipped(zip_of({item}, shape)), (ZipFiles{{"a.obj", "v"}}));
  }
}

TEST(Zip, TextsOfAllSizesAndLevelsComeBack) {
  test::ZipItem item;
  for (const std::size_t size : {1U, 2U, 255U, 32'768U, 70'000U}) {
    std::string text;
    for (std::size_t i = 0; text.size() < size; ++i) text += std::to_string(i * i * 7919 % 1000);
    text.resize(size);
    for (int level = 0; level <= 9; level += 3) {
      item = zip_item("a", text);
      item.data = test::zip_deflated(text, level);
      item.local.packed = item.central.packed = item.data.size();
      ASSERT_EQ(unzipped(zip_of({item})), (ZipFiles{{"a", text}})) << size << ", " << level;
    }
  }
}

// ---- limits -------------------------------------------------------------------------------------

TEST(Zip, LimitsAreKeptToTheByte) {
  const std::string archive = small_zip();
  const std::uint64_t together = four_corners.size() + 10;
  ZipLimits limits;
  limits.bytes = together;
  limits.files = 3;
  Faults faults;
  EXPECT_EQ(unzipped(archive, faults, limits), small_zip_files);
  EXPECT_TRUE(faults.empty());
  limits.bytes = together - 1;
  limits.files = 2;
  expect_zip_refused(archive,
                     {{FaultKind::limit, "", "42", "at most 41 bytes of all files together"},
                      {FaultKind::limit, "", "3", "at most 2 files"}},
                     limits);
}

TEST(Zip, FilesAreUnpackedToAHundredTimesTheirSizeFrom64KiBOn) {
  const std::size_t free_of_it = 65'536;
  EXPECT_EQ(unzipped(zip_of({zip_item("a", std::string(free_of_it, '0'))})),
            (ZipFiles{{"a", std::string(free_of_it, '0')}}));
  const std::string more(free_of_it + 1, '0');
  ASSERT_LT(zip_item("a", more).data.size() * 100, more.size());
  expect_zip_refused(zip_of({zip_item("a~/0", more), zip_item("b", "b")}),
                     {{FaultKind::limit, "/a~0~10", "65537", "at most 100 bytes for each"}});
  // Exactly as much as is allowed.
  ZipItem item = zip_item("a", more);
  ZipLimits limits;
  limits.ratio = (more.size() + item.data.size() - 1) / item.data.size();
  Faults faults;
  EXPECT_EQ(unzipped(zip_of({item}), faults, limits), (ZipFiles{{"a", more}}));
  --limits.ratio;
  EXPECT_EQ(unzipped(zip_of({item}), faults, limits), ZipFiles());
  EXPECT_EQ(faults.count(), 1U);
}

TEST(Zip, SizesThatAreLiesCostNothing) {
  std::vector<ZipItem> items;
  for (int i = 0; i < 3; ++i) {
    items.push_back(zip_item(std::string(1, static_cast<char>('a' + i)), "v"));
    items.back().local.unpacked = items.back().central.unpacked = 0xFFFFFFFE;
  }
  expect_zip_refused(zip_of(items), {{FaultKind::limit, "/a", "4294967294", "100 bytes for each"},
                                     {FaultKind::limit, "/b", "4294967294", "100 bytes for each"},
                                     {FaultKind::limit, "/c", "4294967294", "100 bytes for each"},
                                     {FaultKind::limit, "", "12884901882", "268435456 bytes"}});
}

TEST(Zip, OfManyFaultsTheFirst20AreTold) {
  std::vector<ZipItem> items(100, zip_item("../a", "v"));
  Faults faults;
  unzipped(zip_of(items), faults);
  EXPECT_EQ(faults.list().size(), Faults::most);
}

TEST(Zip, EndsWhenThatIsAskedFor) {
  std::stop_source source;
  Faults faults(source.get_token());
  source.request_stop();
  EXPECT_THROW(unzipped(small_zip(), faults), Stopped);
}

}  // namespace
}  // namespace tia
