// Archives are unpacked by a process that may die of them, and what it says is not believed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/stores/exchange_parts.h"
#include "server/stores/model_exchange.h"
#include "server/stores/model_reader.h"
#include "server/stores/unpack_exchange.h"
#include "tests/core/models/zip_files.h"
#include "tests/server/process_support.h"

namespace tia::server {
namespace {

using namespace test;

ModelBytes seen(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
std::string text_in(ModelBytes bytes) { return {bytes.begin(), bytes.end()}; }

const std::string two_files =
    zip_of({zip_item("chair/a.obj", std::string(3000, 'v')), zip_item("b.mtl", "", false)});

// What the process does, done here.
std::vector<std::uint8_t> unpacked_here(const std::string& archive, const ZipLimits& limits = {}) {
  const std::string text = unpack_head(limits) + archive;
  std::vector<std::uint8_t> all;
  answer_to(seen(text)).each_part([&](ModelBytes part) {
    all.insert(all.end(), part.begin(), part.end());
  });
  return all;
}

TEST(Unpacking, GivesTheFilesOfAnArchive) {
  const ModelReader reader({std::uint64_t{1} << 30U, 20}, tia_program());
  const ModelReader::Unpacked apart = reader.unpack(seen(two_files), {});
  EXPECT_EQ(text_in(apart.bytes), text_in(unpacked_here(two_files)));
  ASSERT_EQ(apart.files.size(), 2U);
  EXPECT_EQ(apart.files[0].path, "chair/a.obj");
  EXPECT_EQ(text_in(apart.files[0].bytes), std::string(3000, 'v'));
  EXPECT_EQ(apart.files[1].path, "b.mtl");
  EXPECT_TRUE(apart.files[1].bytes.empty());
}

TEST(Unpacking, TellsTheFaultsThatTheSameCodeTells) {
  const ModelReader reader({std::uint64_t{1} << 30U, 20}, tia_program());
  for (const std::string& archive :
       {std::string("PK\3\4 and nothing else"), two_files.substr(0, two_files.size() - 30),
        zip_of({zip_item("../a", "x")}), zip_of({zip_item("a", std::string(100'000, 'x'))})}) {
    const ZipLimits limits{.bytes = 50'000};
    Faults here;
    unpack_zip(seen(archive), limits, here);
    try {
      reader.unpack(seen(archive), limits);
      ADD_FAILURE();
    } catch (const InputError& error) {
      ASSERT_FALSE(here.list().empty());
      EXPECT_EQ(error.faults().front().pointer, here.list().front().pointer);
      const FaultKind kind = here.list().front().kind;  // of the archive, not of the request
      EXPECT_EQ(error.faults().front().kind,
                kind == FaultKind::malformed ? FaultKind::unreadable : kind);
    }
  }
}

TEST(Unpacking, BelievesNoAnswerThatDoesNotFit) {
  const std::vector<std::uint8_t> good = unpacked_here(two_files);
  EXPECT_EQ(unpacked_files(good, {.bytes = 3000, .files = 2}).size(), 2U);
  EXPECT_THROW(unpacked_files(good, {.bytes = 2999}), NoAnswer);
  EXPECT_THROW(unpacked_files(good, {.files = 1}), NoAnswer);
  for (std::size_t size = 0; size < good.size(); size += size < 80 ? 1 : 97)
    EXPECT_THROW(unpacked_files(std::span(good).first(size), {}), NoAnswer) << size;
  std::vector<std::uint8_t> other = good;
  other.push_back(0);
  EXPECT_THROW(unpacked_files(other, {}), NoAnswer);
  other = good, other[0] = model_follows;
  EXPECT_THROW(unpacked_files(other, {}), NoAnswer);
}

TEST(Unpacking, BelievesNoPathThatIsNotCleanOrComesTwice) {
  const auto answer_of = [](const std::vector<std::string>& paths) {
    std::vector<std::uint8_t> bytes{files_follow};
    put_number(std::uint64_t{paths.size()}, bytes);
    for (const std::string& each : paths) {
      put_number(std::uint64_t{each.size()}, bytes);
      put_number(std::uint64_t{0}, bytes);
    }
    for (const std::string& each : paths) bytes.insert(bytes.end(), each.begin(), each.end());
    return bytes;
  };
  EXPECT_EQ(unpacked_files(answer_of({"a", "b/c"}), {}).size(), 2U);
  for (const std::vector<std::string>& bad : {std::vector<std::string>{"../a"},
                                              {"/a"},
                                              {"a//b"},
                                              {""},
                                              {"a\\b"},
                                              {"__MACOSX/a"},
                                              {"a", "a"}})
    EXPECT_THROW(unpacked_files(answer_of(bad), {}), NoAnswer) << bad.front();
}

TEST(Unpacking, RefusesWhatIsNoRequest) {
  for (const std::string& bad : {std::string("{\"unpack\":true}\n"),
                                 std::string("{\"unpack\":true,\"bytes\":1,\"files\":\"x\"}\n")})
    EXPECT_THROW(answer_to(seen(bad + two_files)), std::exception) << bad;
}

}  // namespace
}  // namespace tia::server
