// Kept scenes have owners: keys that delete them, an age at which unused ones go, and shares.
#include <httplib.h>

#include <filesystem>
#include <thread>

#include "core/scene/read_scene.h"
#include "server/stores/digest.h"
#include "server/stores/scene_file.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

constexpr const char* delete_key = "Tia-Delete-Key";
constexpr std::int64_t room = 1 << 24;

struct Posted {
  std::string id, key;
};

Posted posted(Host& asked, const std::string& title, const std::string& peer = "10.0.0.1") {
  Request request{"POST", "/scenes", {}, R"({"title":")" + title + "\"}", Host::id};
  request.peer = peer;
  const Response response = asked.ask(request);
  EXPECT_EQ(response.status, 201) << response.body;
  EXPECT_EQ(header(response, "Cache-Control"), "no-store");
  return {text_at(parse_json(response.body), "id"), header(response, delete_key).value_or("")};
}
int deleted(Host& asked, const std::string& id, const std::string& key) {
  return asked.ask("DELETE", "/scenes/" + id, "", {{delete_key, key}}).status;
}

TEST(DeleteScenes, TheKeyThatPostHasAnsweredDeletes) {
  Host own;
  const auto [id, key] = posted(own, "mine");
  EXPECT_THAT(key, testing::MatchesRegex("[0-9a-f]{32}"));
  EXPECT_EQ(own.get("/render?width=8&height=8&scene=" + id).status, 200);
  EXPECT_EQ(deleted(own, id, key), 204);
  EXPECT_EQ(own.get("/scenes/" + id).status, 404);
  EXPECT_EQ(own.get("/render?width=8&height=8&scene=" + id).status, 422);
  EXPECT_EQ(deleted(own, id, key), 404);
  EXPECT_EQ(own.kept().count(), 0U);
  EXPECT_EQ(own.kept().bytes(), 0U);
}

TEST(DeleteScenes, NoOtherKeyDoes) {
  Host own;
  const auto [id, key] = posted(own, "mine");
  const std::string other = posted(own, "another").key;
  for (const std::string& wrong : {std::string(), other, sha256_hex(key), key + "0"}) {
    const Response refused = own.ask("DELETE", "/scenes/" + id, "", {{delete_key, wrong}});
    EXPECT_EQ(refused.status, 403) << wrong;
    EXPECT_THAT(problem_of(refused).detail, testing::HasSubstr(delete_key));
  }
  EXPECT_EQ(deleted(own, "thesis", key), 404);
  EXPECT_EQ(own.get("/scenes/" + id).status, 200);
}

TEST(DeleteScenes, WhatSeveralHaveKeptGoesWithTheLast) {
  Host own;
  const Posted first = posted(own, "ours"), second = posted(own, "ours", "10.0.0.2");
  EXPECT_EQ(first.id, second.id);
  EXPECT_NE(first.key, second.key);
  EXPECT_EQ(deleted(own, first.id, first.key), 204);
  EXPECT_EQ(own.get("/scenes/" + first.id).status, 200);
  EXPECT_EQ(deleted(own, first.id, first.key), 403);
  EXPECT_EQ(deleted(own, first.id, second.key), 204);
  EXPECT_EQ(own.get("/scenes/" + first.id).status, 404);
}

TEST(DeleteScenes, AfterSixtyFourOwnersTheNextIsToldNoKey) {
  Host own;
  for (int i = 0; i < 64; ++i) EXPECT_NE(posted(own, "all's").key, "");
  EXPECT_EQ(posted(own, "all's").key, "");
}

TEST(DeleteScenes, TheFileForgetsThemTooAndKeepsNoKeyInTheClear) {
  const Folder folder;
  std::string id, key;
  {
    const Tia tia({"--port", "0", "--data-dir", folder.file("")});
    const auto answer = tia.client().Post("/scenes", R"({"title":"kept"})", "application/json");
    id = text_at(parse_json(answer->body), "id");
    key = answer->get_header_value(delete_key);
    EXPECT_EQ(tia.get("/scenes/" + id).status, 200);
  }
  for (const char* file : {"scenes.sqlite", "scenes.sqlite-wal"})
    if (std::filesystem::exists(folder.file(file))) {
      EXPECT_EQ(file_bytes(folder.file(file)).find(key), std::string::npos) << file;
    }
  const Tia again({"--port", "0", "--data-dir", folder.file("")});
  const auto ask = [&](const std::string& with) {
    return again.client().Delete(("/scenes/" + id).c_str(), {{delete_key, with}})->status;
  };
  EXPECT_EQ(ask(std::string(32, '0')), 403);
  EXPECT_EQ(ask(key), 204);
  EXPECT_EQ(again.get("/scenes/" + id).status, 404);
  EXPECT_EQ(ask(key), 404);
}

// ---- age ------------------------------------------------------------------------------------

Scene titled(const std::string& title) {
  Scene scene;
  scene.title = title;
  return scene;
}

class Ageing : public testing::TestWithParam<bool> {
 protected:
  SceneStore store() {
    if (!GetParam()) return SceneStore(room);
    return SceneStore(room, std::make_unique<SceneFile>(folder_.file(""), room));
  }
  std::int64_t now_ = 1'000'000;

 private:
  Folder folder_;
};

TEST_P(Ageing, WhatNobodyHasUsedForSoLongIsForgotten) {
  SceneStore store = this->store();
  store.forget_after(100, [this] { return now_; });
  const std::string used = store.keep(titled("used")), unused = store.keep(titled("unused"));
  now_ += 100;
  EXPECT_TRUE(store.find(used));
  now_ += 1;
  EXPECT_FALSE(store.find(unused));
  now_ += 99;
  EXPECT_TRUE(store.find(used));
  now_ += 101;
  EXPECT_FALSE(store.find(used));
  EXPECT_EQ(store.count(), 0U);
}

TEST_P(Ageing, WithoutAnAgeNothingIs) {
  SceneStore store = this->store();
  store.forget_after(0, [this] { return now_; });
  const std::string id = store.keep(titled("old"));
  now_ += std::int64_t{100} * 365 * 86'400;
  EXPECT_TRUE(store.find(id));
}

INSTANTIATE_TEST_SUITE_P(Of, Ageing, testing::Bool(),
                         [](const auto& of) { return of.param ? "TheFile" : "Memory"; });

// ---- shares ---------------------------------------------------------------------------------

// A scene that is deleted while it waits to be read from the file is not put back into memory.
TEST(DeleteScenes, OneThatIsBeingReadIsGoneAllTheSame) {
  const Folder folder;
  const auto file = [&] { return std::make_unique<SceneFile>(folder.file(""), room); };
  const std::string owner_key = "hash";
  Scene scene;
  scene.title = std::string(100'000, 'x');  // a long text
  const std::string id = SceneStore(room, file()).keep(scene, {"a", owner_key, 0});

  SceneStore store(room, file());
  Admission admission({.tickets = 4, .queue = 8});  // one long text at a time
  Pool pool(1);
  LongWork long_work(admission, pool);
  store.read_as(long_work, 1000);
  auto reading = std::make_unique<Admission::Ticket>(admission.read(1 << 20, "other", {}));
  // One who finds another client with more than half of the tickets is let in beside it.
  auto beside = std::make_unique<Admission::Ticket>(admission.read(1 << 20, "another", {}));
  KnownScene read;
  std::jthread reader([&] { read = store.find(id, {"a", {}}); });
  ASSERT_TRUE(eventually([&] { return admission.waiting() == 1; }));
  EXPECT_EQ(store.remove(id, owner_key), Removal::done);
  reading.reset();
  beside.reset();
  reader.join();
  EXPECT_TRUE(read);  // it was there when it was asked for
  EXPECT_FALSE(store.in_memory(id));
  EXPECT_FALSE(store.find(id));
}

TEST(SharesOfScenes, InMemoryAClientBeyondHalfLosesItsOwnOldestFirst) {
  SceneStore probe(room);
  probe.keep(titled("100"));
  const auto each = static_cast<std::int64_t>(probe.bytes());
  SceneStore store(8 * each);
  std::vector<std::string> quiet;
  for (const char* title : {"201", "202", "203"})
    quiet.push_back(store.keep(titled(title), {"quiet", "", 0}));
  for (int i = 300; i < 400; ++i) store.keep(titled(std::to_string(i)), {"loud", "", 0});
  for (const std::string& id : quiet) EXPECT_TRUE(store.in_memory(id)) << id;
  EXPECT_EQ(store.count(), 8U);
}

TEST(SharesOfScenes, InMemoryAClientBeyondHalfOfTheirNumberLosesItsOwnToo) {
  SceneStore store(room, 8);
  const std::string quiet = store.keep(titled("200"), {"quiet", "", 0});
  for (int i = 300; i < 400; ++i) store.keep(titled(std::to_string(i)), {"loud", "", 0});
  EXPECT_TRUE(store.in_memory(quiet));
  EXPECT_EQ(store.count(), 8U);
}

TEST(SharesOfScenes, OwnersOfASceneTakeMemoryToo) {
  SceneStore store(room);
  store.keep(titled("200"), {"a", sha256_hex("1"), 0});
  const std::size_t one = store.bytes();
  store.keep(titled("200"), {"a", sha256_hex("2"), 0});
  EXPECT_GE(store.bytes(), one + sizeof(std::string) + 64);
  EXPECT_EQ(store.count(), 1U);
}

TEST(SharesOfScenes, InTheFileAClientMayHaveHalf) {
  const Folder folder;
  SceneFile file(folder.file(""), 1 << 20);
  const auto keep = [&](int number, const char* client) {
    const std::string text = std::to_string(number) + std::string(32 << 10, 'x');
    try {
      file.keep(sha256_hex(text), text, {client, sha256_hex(std::to_string(number)), 1});
      return 201;
    } catch (const HttpError& error) {
      EXPECT_EQ(error.type(), "storage-full");
      return 507;
    }
  };
  int loud = 0;
  while (loud < 100 && keep(loud, "loud") == 201) ++loud;
  EXPECT_GE(loud, 12);
  EXPECT_LE(loud, 16);
  EXPECT_EQ(keep(1000, "quiet"), 201);
}

}  // namespace
}  // namespace tia::test
