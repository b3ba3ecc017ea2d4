// The file of kept scenes: what is there after a crash, and what is said of one that cannot be
// used.
#include "server/stores/scene_file.h"

#include <array>
#include <csignal>
#include <fstream>
#include <latch>

#include "server/contract/problem.h"
#include "server/stores/digest.h"
#include "tests/core/support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

constexpr std::int64_t room = 1 << 24;

std::string scene_text(int number) { return "{\"title\":\"" + std::to_string(number) + "\"}"; }
std::string keep(SceneFile& file, const std::string& text) {
  const std::string id = sha256_hex(text);
  file.keep(id, text);
  return id;
}
// Each on a thread of its own, all at the same moment.
void at_once(std::ptrdiff_t count, const std::function<void(std::ptrdiff_t)>& each) {
  std::latch all(count);
  std::vector<std::jthread> threads;
  for (std::ptrdiff_t i = 0; i < count; ++i)
    threads.emplace_back([&, i] {
      all.arrive_and_wait();
      each(i);
    });
}
// What opening says against a folder; "" where it opens.
std::string refusal(const std::string& folder) {
  try {
    const SceneFile file(folder, room);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(SceneFile, GivesBackWhatItKeeps) {
  Folder folder;
  SceneFile file(folder.file(""), room);
  const std::string empty = keep(file, ""), text = keep(file, "t\u00ECa"),
                    large = keep(file, std::string(3 << 20, 'x'));
  EXPECT_EQ(file.find(empty), "");
  EXPECT_EQ(file.find(text), "t\u00ECa");
  EXPECT_EQ(file.find(large), std::string(3 << 20, 'x'));
  EXPECT_EQ(keep(file, "t\u00ECa"), text);
  EXPECT_EQ(file.find(sha256_hex("other")), std::nullopt);
  EXPECT_GT(file.bytes(), 3 << 20);
}

TEST(SceneFile, HasItStillWhenItIsOpenedAgainOrTwice) {
  Folder folder;
  std::string id;
  {
    SceneFile file(folder.file(""), room);
    id = keep(file, "a");
  }
  SceneFile again(folder.file(""), room), twice(folder.file(""), room);
  EXPECT_EQ(again.find(id), "a");
  const std::string other = keep(again, "b");
  EXPECT_EQ(twice.find(other), "b");
}

TEST(SceneFile, ThatManyBeginAtOnceIsOneForAllOfThem) {
  constexpr int many = 8;
  for (int round = 0; round < (sanitized() ? 4 : 40); ++round) {
    Folder folder;
    std::array<std::unique_ptr<SceneFile>, many> files;
    at_once(many, [&](std::ptrdiff_t i) {
      try {
        auto& file = files[static_cast<std::size_t>(i)];
        file = std::make_unique<SceneFile>(folder.file(""), room);
        keep(*file, scene_text(static_cast<int>(i)));
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
    });
    ASSERT_FALSE(testing::Test::HasFailure()) << round;
    for (const auto& file : files)
      for (int i = 0; i < many; ++i)
        EXPECT_EQ(file->find(sha256_hex(scene_text(i))), scene_text(i));
  }
}

TEST(SceneFile, ThatIsFullSaysSoAndLosesNothing) {
  Folder folder;
  SceneFile file(folder.file(""), 1 << 20);
  std::vector<std::string> ids;
  std::string refused;
  for (int i = 0; i < 100 && refused.empty(); ++i) try {
      ids.push_back(keep(file, scene_text(i) + std::string(50'000, ' ')));
    } catch (const HttpError& error) {
      refused = std::string(error.type());
    }
  EXPECT_EQ(refused, "storage-full");
  EXPECT_GT(ids.size(), 10U);
  EXPECT_LE(file.bytes(), 1 << 20);
  for (const std::string& id : ids) EXPECT_TRUE(file.find(id));
  EXPECT_NO_THROW(file.keep(ids[0], scene_text(0) + std::string(50'000, ' ')));  // is there already
}

TEST(SceneFile, ThatCannotBeHadIsRefusedByName) {
  using testing::HasSubstr;
  Folder folder;
  EXPECT_THAT(refusal(folder.file("missing")), HasSubstr(folder.file("missing")));
  EXPECT_THAT(refusal(folder.file("missing")), HasSubstr("TIA_DATA_DIR"));
  const std::string path = folder.file(SceneFile::name);
  std::ofstream(path) << std::string(5000, '?');
  EXPECT_THAT(refusal(path), HasSubstr("a folder"));
  EXPECT_THAT(refusal(folder.file("")), HasSubstr("not a database"));
  EXPECT_EQ(file_bytes(path), std::string(5000, '?'));              // it may be somebody's
  EXPECT_THAT(refusal("/proc/self"), HasSubstr("unable to open"));  // where nobody may write
}

TEST(SceneFile, ThatIsAnotherProgramsIsRefused) {
  Folder folder;
  { SceneFile file(folder.file(""), room); }
  const std::string path = folder.file(SceneFile::name);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(68).write("Abc\0", 4).flush();  // the header's application id
  EXPECT_THAT(refusal(folder.file("")), testing::HasSubstr("another program's"));
  file.seekp(68).write("Tia\0", 4).flush();
  EXPECT_EQ(refusal(folder.file("")), "");
  file.seekp(60).write("\0\0\0\3", 4).flush();  // and its version
  EXPECT_THAT(refusal(folder.file("")), testing::HasSubstr("another version"));
}

// Whatever 64 bytes are overwritten: the start says so, or nothing was harmed.
TEST(SceneFile, ThatIsDamagedIsRefusedUnlessAllItsTextsAreWhole) {
  Folder folder;
  std::map<std::string, std::string> texts;
  {
    SceneFile file(folder.file(""), room);
    for (int i = 0; i < 40; ++i) {
      const std::string text =
          scene_text(i) + std::string(static_cast<std::size_t>(997 * i % 5000), ' ');
      texts[keep(file, text)] = text;
    }
  }
  const std::string path = folder.file(SceneFile::name), whole = file_bytes(path);
  int refused = 0, harmless = 0;
  for (std::size_t place = 0; place < whole.size(); place += 1000) {
    std::string wrong = whole;
    for (std::size_t i = 0; i < 64 && place + i < wrong.size(); ++i) wrong[place + i] ^= 0x5A;
    std::ofstream(path, std::ios::binary) << wrong;
    if (!refusal(folder.file("")).empty()) {
      ++refused;
      continue;
    }
    SceneFile file(folder.file(""), room);
    for (const auto& [id, text] : texts) EXPECT_EQ(file.find(id), text) << place;
    ++harmless;
  }
  EXPECT_GT(refused, 50);
  EXPECT_LT(harmless, refused);
}

// ---- the whole program ----------------------------------------------------------------------

Process::Words with_data(const Folder& folder) {
  return {"--port", "0", "--data-dir", folder.file("")};
}
Response post(int port, const std::string& scene) {
  return test::exchange(port, "POST /scenes HTTP/1.1\r\nHost: x\r\nContent-Length: " +
                                  std::to_string(scene.size()) + "\r\n\r\n" + scene);
}

// While four clients send scenes the server is killed; whoever was told 201 finds it afterwards.
TEST(KeptScenes, OutliveAnyCrashOnceTheyAreConfirmed) {
  Folder folder;
  std::map<std::string, std::string> confirmed;
  const int kills = rounds(6, 3);
  for (int round = 0; round < kills; ++round) {
    std::mutex mutex;
    Tia tia(with_data(folder));
    std::atomic<int> count = 0;
    std::vector<std::jthread> clients;
    for (int c = 0; c < 4; ++c)
      clients.emplace_back([&, c] {
        for (int i = 0;; ++i) try {
            const std::string scene = scene_text(1000 * round + 100'000 * c + i);
            const Response kept = post(tia.port(), scene);
            if (kept.status != 201) return;
            const std::lock_guard lock(mutex);
            confirmed[text_at(parse_json(kept.body), "id")] = scene;
            ++count;
          } catch (const std::runtime_error&) {  // killed
            return;
          }
      });
    EXPECT_TRUE(eventually([&] { return count > 20 + 7 * round; }));
    tia.signal(SIGKILL);
    tia.wait();
  }
  ASSERT_GT(confirmed.size(), 20U * static_cast<std::size_t>(kills));
  Tia tia(with_data(folder));
  Connection connection(tia.port());
  for (const auto& [id, scene] : confirmed) {
    connection.send("GET /scenes/" + id + " HTTP/1.1\r\nHost: x\r\n\r\n");
    ASSERT_EQ(connection.receive().body, scene);
  }
  const std::string& id = confirmed.begin()->first;
  EXPECT_EQ(tia.get("/render?width=8&height=8&scene=" + id).status, 200);
}

TEST(KeptScenes, AreSharedByServersThatStartAtOnceInANewFolder) {
  constexpr int many = 8;
  for (int round = 0; round < (sanitized() ? 1 : 8); ++round) {
    Folder folder;
    std::array<std::unique_ptr<Tia>, many> servers;
    std::array<std::string, many> places;
    at_once(many, [&](std::ptrdiff_t i) {
      const auto own = static_cast<std::size_t>(i);
      try {
        servers[own] = std::make_unique<Tia>(with_data(folder));
        const Response kept = post(servers[own]->port(), scene_text(static_cast<int>(i)));
        EXPECT_EQ(kept.status, 201) << kept.body;
        places[own] = text_at(parse_json(kept.body), "location");
      } catch (const std::exception& error) {
        ADD_FAILURE() << error.what();
      }
    });
    ASSERT_FALSE(testing::Test::HasFailure()) << round;
    for (const auto& server : servers)
      for (int i = 0; i < many; ++i)
        EXPECT_EQ(server->get(places[static_cast<std::size_t>(i)]).body, scene_text(i));
  }
}

TEST(KeptScenes, AreServedWithoutOpeningAnotherFile) {
  Folder folder;
  Tia tia(with_data(folder));
  post(tia.port(), scene_text(1));
  std::set<std::string> open;
  for (const auto& entry : std::filesystem::directory_iterator(tia.proc("fd"))) {
    std::error_code closed;  // by now
    const auto is = std::filesystem::read_symlink(entry.path(), closed);
    if (is.string().starts_with(folder.file(""))) open.insert(is.filename());
  }
  EXPECT_THAT(open,
              testing::ElementsAre("jobs.sqlite", "jobs.sqlite-wal", "models", "scenes.sqlite",
                                   "scenes.sqlite-shm", "scenes.sqlite-wal"));
}

TEST(KeptScenes, AFileThatCannotBeUsedEndsTheStartWith2) {
  Folder folder;
  std::ofstream(folder.file(SceneFile::name)) << std::string(5000, '?');
  const Finished ended = run(with_data(folder));
  EXPECT_EQ(ended.status, 2);
  EXPECT_THAT(ended.err, testing::HasSubstr(SceneFile::name));
}

TEST(KeptScenes, ThatFindNoRoomAreAnswered507AndOthersGoOn) {
  Folder folder;
  Process::Words words = with_data(folder);
  words.insert(words.end(), {"--max-data-bytes", "1048576", "--max-scenes-bytes", "0"});
  Tia tia(words);
  const std::string filler(200'000, 'x');
  std::string first;
  Response last;
  for (int i = 0; i < 20; ++i) {
    last = post(tia.port(), "{\"title\":\"" + std::to_string(i) + filler + "\"}");
    if (last.status != 201) break;
    if (first.empty()) first = text_at(parse_json(last.body), "location");
  }
  EXPECT_EQ(last.status, 507);
  EXPECT_EQ(problem_of(last).type, "/problems/storage-full");
  EXPECT_THAT(problem_of(last).detail, testing::HasSubstr("TIA_MAX_DATA_BYTES"));
  EXPECT_EQ(tia.get(first).status, 200);
  EXPECT_EQ(tia.get("/render?width=8&height=8").status, 200);
}

}  // namespace
}  // namespace tia::test
