// Models' files on the disk: whole or not there, and bounded.
#include "server/stores/model_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "server/contract/problem.h"
#include "server/stores/digest.h"
#include "tests/server/process_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using server::ModelFolder;

constexpr std::int64_t plenty_of_disk = 1 << 20;

TEST(ModelFolder, KeepsBytesByTheirNameForTheNextOne) {
  const Folder folder;
  const std::string id = sha256_hex("abc");
  {
    ModelFolder models(folder.file(""), plenty_of_disk);
    EXPECT_FALSE(models.contains(id));
    EXPECT_FALSE(models.find(id));
    models.keep(id, {"a", "", "bc"});
    models.keep(id, {"abc"});
    EXPECT_EQ(models.count(), 1U);
    EXPECT_EQ(models.bytes(), 3);
  }
  EXPECT_EQ(file_bytes(folder.file("models/" + id)), "abc");
  std::ofstream(folder.file("models/another")) << "what is no model's is not counted";
  ModelFolder models(folder.file(""), plenty_of_disk);
  EXPECT_TRUE(models.contains(id));
  EXPECT_EQ(models.find(id), "abc");
  EXPECT_EQ(models.count(), 1U);
  EXPECT_EQ(models.bytes(), 3);
  models.remove(id);
  models.remove(id);
  EXPECT_FALSE(models.contains(id));
  EXPECT_EQ(models.count(), 0U);
  EXPECT_EQ(models.bytes(), 0);
}

TEST(ModelFolder, ThatIsFullSaysSoAndKeepsWhatItHas) {
  const Folder folder;
  ModelFolder models(folder.file(""), 5);
  const std::string first = sha256_hex("12345"), second = sha256_hex("6");
  models.keep(first, {"12345"});
  try {
    models.keep(second, {"6"});
    ADD_FAILURE();
  } catch (const HttpError& error) {
    EXPECT_EQ(error.type(), "storage-full");
    EXPECT_THAT(error.detail(), testing::HasSubstr("TIA_MAX_DATA_BYTES"));
  }
  EXPECT_FALSE(models.contains(second));
  EXPECT_EQ(models.find(first), "12345");
  models.keep(first, {"12345"});
}

TEST(ModelFolder, ThatCannotBeUsedEndsTheStartWithItsName) {
  const Folder folder;
  EXPECT_THROW(ModelFolder(folder.file("none"), plenty_of_disk), std::runtime_error);
  std::ofstream(folder.file("models")) << "a file";
  try {
    const ModelFolder models(folder.file(""), plenty_of_disk);
    ADD_FAILURE();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("TIA_DATA_DIR"));
  }
}

// ---- files that are on their way ----------------------------------------------------------------

TEST(SentFile, IsHashedAsItComesAndHasNoNameBeforeItIsKept) {
  const Folder folder;
  ModelFolder models(folder.file(""), plenty_of_disk);
  const std::string id = sha256_hex("abcdef");
  {
    const auto file = models.begin();
    file->append("abc");
    file->append("def");
    EXPECT_EQ(file->size(), 6U);
    EXPECT_EQ(models.bytes(), 6);
    EXPECT_EQ(file->contents(), "abcdef");
    EXPECT_EQ(file->sha256(), id);
    EXPECT_TRUE(std::filesystem::is_empty(folder.file("models")));
    models.keep(id, file->file());
    EXPECT_EQ(models.find(id), "abcdef");
  }
  EXPECT_EQ(models.count(), 1U);
  EXPECT_EQ(models.bytes(), 6);
}

TEST(SentFile, ThatIsNotKeptOrIsThereAlreadyLeavesNothing) {
  const Folder folder;
  ModelFolder models(folder.file(""), plenty_of_disk);
  models.begin()->append("abc");
  EXPECT_EQ(models.bytes(), 0);
  models.keep(sha256_hex("abc"), {"abc"});
  {
    const auto file = models.begin();
    file->append("abc");
    models.keep(sha256_hex("abc"), file->file());
    EXPECT_FALSE(file->file().publish(sha256_hex("abc")));
  }
  EXPECT_EQ(models.count(), 1U);
  EXPECT_EQ(models.bytes(), 3);
}

TEST(SentFile, CountsAmongWhatTheFolderMayHaveWhileItComes) {
  const Folder folder;
  ModelFolder models(folder.file(""), 5);
  const auto first = models.begin(), second = models.begin();
  first->append("123");
  second->append("45");
  EXPECT_THROW(second->append("6"), HttpError);
  EXPECT_EQ(models.bytes(), 5);
}

// It is changed under the name that it has by then.
TEST(SentFile, IsHeldAgainstWhatHasComeWhenItIsRead) {
  const Folder folder;
  ModelFolder models(folder.file(""), plenty_of_disk);
  const auto file = models.begin();
  file->append("abc");
  models.keep(sha256_hex("abc"), file->file());
  std::ofstream(folder.file("models/" + sha256_hex("abc"))) << "abd";
  EXPECT_THROW(file->contents(), StorageError);
}

TEST(SentFile, OfNothingIsAnEmptyFile) {
  const Folder folder;
  ModelFolder models(folder.file(""), plenty_of_disk);
  models.keep(sha256_hex(""), models.begin()->file());
  EXPECT_EQ(models.find(sha256_hex("")), "");
}

// A folder where a file should be can be opened and not read.
TEST(ModelFolder, ThatCannotReadAFileSaysSo) {
  const Folder folder;
  ModelFolder models(folder.file(""), plenty_of_disk);
  const std::string id = sha256_hex("abc");
  std::filesystem::create_directory(folder.file("models/" + id));
  EXPECT_THROW(models.find(id), StorageError);
  EXPECT_THROW(models.remove(id), StorageError);
}

}  // namespace
}  // namespace tia::test
