// Kept models: what stays, what is read again, and what becomes of readers that die.
#include "server/stores/model_store.h"

#include <sys/stat.h>

#include <fstream>

#include "server/contract/problem.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

/// A store with all that it needs.
class Models {
 public:
  explicit Models(std::int64_t max_bytes = 1 << 20, const std::string& data_dir = "",
                  const std::string& program = tia_program())
      : store_(ModelReader({}, program), {max_bytes, {}}, {memory_, long_work_, metrics_},
               data_dir.empty() ? nullptr : std::make_unique<ModelFolder>(data_dir, 1 << 20),
               [this] { return now_; }) {}

  ModelStore* operator->() { return &store_; }
  std::string keep(const NamedTexts& texts) {
    return text_at(parse_json(*store_.keep(upload_of_texts(texts), {}).known.text), "id");
  }
  std::string keep(const std::string& name) { return keep({{"part.stl", stl_text(name)}}); }
  MemoryAccount& memory() { return memory_; }
  void pass(std::chrono::seconds time) { now_ += time; }
  /// How often models have been read, by what came of it.
  double reads(const std::string& result) {
    double sum = 0;
    for (const auto& [name, value] : series_of(metrics_.text({})))
      if (name.starts_with("tia_model_reads_total") && name.ends_with("result=\"" + result + "\"}"))
        sum += value;
    return sum;
  }
  double deaths() { return series_of(metrics_.text({})).at("tia_model_reader_deaths_total"); }

 private:
  MemoryAccount memory_{1 << 30};
  Admission admission_{{8, 64, 2, 15}};
  Pool pool_{2};
  LongWork long_work_{admission_, pool_};
  Metrics metrics_;
  ModelStore::Time now_{};
  ModelStore store_;
};

TEST(ModelStore, FindsWhatItKeepsAndReadsItOnce) {
  Models models;
  const std::string id = models.keep("part");
  EXPECT_TRUE(models->contains(id));
  const KnownModel known = models->find(id, {});
  ASSERT_TRUE(known);
  EXPECT_EQ(known.model->model->format, "stl");
  EXPECT_EQ(known.model->model->meshes.at(0).parts.at(0).triangles(), 1U);
  EXPECT_EQ(models.keep("part"), id);
  EXPECT_EQ(models.reads("read"), 1);
  EXPECT_EQ(models->counts().kept, 1U);
  EXPECT_EQ(models->counts().read, 1U);
}

TEST(ModelStore, KnowsNothingElse) {
  Models models;
  for (const std::string& id : {std::string(64, 'a'), std::string("parts"), std::string("../x")}) {
    EXPECT_FALSE(models->contains(id));
    EXPECT_FALSE(models->find(id, {}));
  }
}

TEST(ModelStore, ReadsAgainWhatHasGivenWay) {
  Models models;
  const std::string id = models.keep(obj_and_mtl());
  const std::string text = *models->find(id, {}).text;
  EXPECT_GT(models.memory().held(MemoryAccount::read_models), 0);
  EXPECT_GT(models->give_way(1), 0);
  EXPECT_EQ(models->counts().read, 0U);
  EXPECT_EQ(models.memory().held(MemoryAccount::read_models), 0);
  EXPECT_EQ(*models->find(id, {}).text, text);
  EXPECT_EQ(models.reads("read"), 2);
}

TEST(ModelStore, InMemoryLetsGoOfTheOneThatNobodyHasAskedForLongest) {
  const auto entry = static_cast<std::int64_t>(512 + stl_text("a").size());
  Models models(2 * entry + 1);
  const std::string a = models.keep("a"), b = models.keep("b");
  EXPECT_TRUE(models->find(a, {}));
  const std::string c = models.keep("c");
  EXPECT_TRUE(models->contains(a));
  EXPECT_FALSE(models->contains(b));
  EXPECT_FALSE(models->find(b, {}));
  EXPECT_TRUE(models->contains(c));
  EXPECT_EQ(models.memory().held(MemoryAccount::models), 2 * entry);
}

TEST(ModelStore, InMemoryRefusesOneThatDoesNotFitAloneNamingTheOption) {
  Models models(513);
  try {
    models.keep("a");
    ADD_FAILURE();
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().front().kind, FaultKind::limit);
    EXPECT_THAT(error.what(), testing::HasSubstr("TIA_MAX_MODELS_BYTES"));
  }
  EXPECT_EQ(models->counts().kept, 0U);
}

TEST(ModelStore, KeepsNothingThatCannotBeRead) {
  Models models;
  EXPECT_THROW(models.keep({{"a", "solid a\nfacet"}}), InputError);
  EXPECT_THROW(models.keep({{"a", "nothing that is known"}}), InputError);
  EXPECT_EQ(models->counts().kept, 0U);
  EXPECT_EQ(models.reads("refused"), 2);
}

TEST(ModelStore, WithAFolderIsFoundByTheNextOneAndTakesNoMemory) {
  const Folder folder;
  std::string id, text;
  {
    Models models(0, folder.file(""));
    id = models.keep(obj_and_mtl());
    text = *models->find(id, {}).text;
    EXPECT_EQ(models.memory().held(MemoryAccount::models), 0);
  }
  Models models(1 << 20, folder.file(""));
  EXPECT_EQ(models->counts().kept, 1U);
  EXPECT_EQ(*models->find(id, {}).text, text);
  EXPECT_FALSE(models->find(std::string(64, 'a'), {}));
}

TEST(ModelStore, NeverGivesWhatIsDamagedAndMendsItWhereItComesAgain) {
  const Folder folder;
  Models models(0, folder.file(""));
  const std::string id = models.keep("part");
  std::ofstream(folder.file("models/" + id)) << stl_text("past");
  EXPECT_THROW(models->find(id, {}), StorageError);
  EXPECT_EQ(models.keep("part"), id);
  EXPECT_TRUE(models->find(id, {}));
}

/// A program that does what a script says in place of reading.
class BadReader {
 public:
  explicit BadReader(const std::string& script) {
    std::ofstream(file_) << "#!/bin/sh\ncat > /dev/null\n" << script << '\n';
    chmod(file_.c_str(), 0700);
  }
  const std::string& program() const { return file_; }

 private:
  Folder folder_;
  std::string file_ = folder_.file("reader");
};

TEST(ModelStore, ReadsNothingForAnHourOfWhatAReaderHasDied) {
  const Folder folder;
  const BadReader dying("echo >> " + folder.file("tries") + "; kill -SEGV $$");
  const auto tries = [&] { return file_bytes(folder.file("tries")).size(); };
  Models models(1 << 20, "", dying.program());
  EXPECT_THROW(models.keep("a"), ReaderDied);
  EXPECT_EQ(models.deaths(), 1);
  EXPECT_EQ(models.reads("died"), 1);
  models.pass(std::chrono::seconds(3599));
  EXPECT_THROW(models.keep("a"), ReaderDied);
  EXPECT_EQ(tries(), 1U);
  EXPECT_THROW(models.keep("b"), ReaderDied);
  EXPECT_EQ(tries(), 2U);
  models.pass(std::chrono::seconds(1));
  EXPECT_THROW(models.keep("a"), ReaderDied);
  EXPECT_EQ(tries(), 3U);
  EXPECT_EQ(models.deaths(), 3);
  EXPECT_EQ(models->counts().kept, 0U);
}

TEST(ModelStore, UnpacksNothingForAnHourThatAReaderHasDiedOf) {
  const Folder folder;
  const BadReader dying("echo >> " + folder.file("tries") + "; kill -SEGV $$");
  const auto tries = [&] { return file_bytes(folder.file("tries")).size(); };
  Models models(1 << 20, "", dying.program());
  const std::vector<std::uint8_t> archive{'P', 'K', 3, 4};
  EXPECT_THROW(models->unpack(archive, {}, {}), ReaderDied);
  EXPECT_EQ(models.deaths(), 1);
  EXPECT_EQ(models.reads("died"), 1);
  models.pass(std::chrono::seconds(3599));
  EXPECT_THROW(models->unpack(archive, {}, {}), ReaderDied);
  EXPECT_EQ(tries(), 1U);
  models.pass(std::chrono::seconds(1));
  EXPECT_THROW(models->unpack(archive, {}, {}), ReaderDied);
  EXPECT_EQ(tries(), 2U);
}

}  // namespace
}  // namespace tia::test
