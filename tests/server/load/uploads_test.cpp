// Models that go to the disk while they come: whole or not there, and never in memory.
#include <httplib.h>
#include <signal.h>

#include <filesystem>

#include "server/stores/digest.h"
#include "tests/core/models/zip_files.h"
#include "tests/server/http/wire.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

namespace fs = std::filesystem;

std::string long_stl(std::size_t bytes, const std::string& name = "part") {
  return stl_text(name + std::string(bytes / 2, ' '));
}
std::string head_of(std::size_t bytes) {
  return "POST /models HTTP/1.1\r\nHost: x\r\nContent-Length: " + std::to_string(bytes) +
         "\r\n\r\n";
}

/// A server with a folder of its own.
class Uploads : public testing::Test {
 protected:
  Process::Words arguments(const Process::Words& more = {}) const {
    Process::Words words{"--port", "0", "--data-dir", folder_.file("")};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  std::vector<std::string> kept() const {
    std::vector<std::string> names;
    for (const auto& file : fs::directory_iterator(folder_.file("models")))
      names.push_back(file.path().filename());
    return names;
  }
  /// Bytes of files that have no name, by the server's descriptors.
  std::size_t on_the_way(const Tia& tia) const {
    const std::string start = fs::canonical(folder_.file("models")).string() + "/#";
    std::size_t bytes = 0;
    for (const auto& each : fs::directory_iterator("/proc/" + std::to_string(tia.pid()) + "/fd")) {
      std::error_code gone;
      if (fs::read_symlink(each.path(), gone).string().starts_with(start))
        bytes += fs::file_size(each.path(), gone);
    }
    return bytes;
  }
  Folder folder_;
};

TEST_F(Uploads, AreTheSameModelsAsWhatIsHeld) {
  Tia tia(arguments());
  const std::string stl = long_stl(1'200'000);
  auto client = tia.client();
  const auto lone = client.Post("/models", stl, "model/stl");
  ASSERT_EQ(lone->status, 201) << lone->body;
  EXPECT_EQ(lone->get_header_value("Location"), "/models/" + sha256_hex(stl));
  EXPECT_EQ(kept(), std::vector{sha256_hex(stl)});
  EXPECT_TRUE(file_bytes(folder_.file("models/" + sha256_hex(stl))) == stl);
  // The same file in a form and in an archive; and the same again.
  const auto form = client.Post("/models", form_of_files({{"a.stl", stl}}), form_type);
  const auto zip = client.Post("/models", zip_of({zip_item("a.stl", stl, false)}), "a/b");
  const auto again = client.Post("/models", stl, "model/stl");
  for (const auto* each : {&form, &zip, &again}) {
    EXPECT_EQ((*each)->status, 200);
    EXPECT_EQ((*each)->body, lone->body);
  }
  NamedTexts bundle = obj_and_mtl();
  bundle[0].second += std::string(1'100'000, '\n');
  const auto several = client.Post("/models", form_of_files(bundle), form_type);
  ASSERT_EQ(several->status, 201) << several->body;
  EXPECT_EQ(several->get_header_value("Location"), "/models/" + upload_of_texts(bundle).id);
  // Whoever has the answer may be quicker than the server is at closing what it has read.
  EXPECT_TRUE(eventually([&] { return on_the_way(tia) == 0; }));
  EXPECT_EQ(kept().size(), 2U);
}

TEST_F(Uploads, AreShownAsStills) {
  Tia tia(arguments());
  const std::string stl = long_stl(1'200'000);
  const std::string query = "?width=16&height=16&integrator=whitted&samples=1";
  const auto sent = tia.client().Post("/still" + query, stl, "model/stl");
  ASSERT_EQ(sent->status, 200) << sent->body;
  const Response by_id = tia.get(sent->get_header_value("Content-Location"));
  EXPECT_TRUE(by_id.body == sent->body);
  EXPECT_EQ(kept().size(), 1U);
}

TEST_F(Uploads, KilledAtAnyByteLeaveNothing) {
  const std::string stl = long_stl(1'200'000), request = head_of(stl.size()) + stl;
  for (const std::size_t cut : {std::size_t{400'000}, std::size_t{1'100'000}, request.size() - 1}) {
    Tia tia(arguments());
    Wire wire(tia.port());
    wire.send(request.substr(0, cut));
    EXPECT_TRUE(eventually([&] { return on_the_way(tia) + 300'000 > cut; })) << cut;
    EXPECT_TRUE(kept().empty());
    tia.signal(SIGKILL);
    tia.wait();
    EXPECT_TRUE(kept().empty()) << cut;
  }
  Tia tia(arguments());
  EXPECT_EQ(tia.get("/models/" + sha256_hex(stl)).status, 404);
  EXPECT_EQ(tia.client().Post("/models", stl, "model/stl")->status, 201);
}

TEST_F(Uploads, ThatBreakOffOrAreNoModelsLeaveNothing) {
  Tia tia(arguments());
  const std::string nothing(1'500'000, '?');
  EXPECT_EQ(tia.client().Post("/models", nothing, "model/stl")->status, 415);
  {
    Wire wire(tia.port());
    wire.send(head_of(3'000'000) + nothing);
    EXPECT_TRUE(eventually([&] { return on_the_way(tia) > 1'000'000; }));
  }
  EXPECT_TRUE(eventually([&] { return on_the_way(tia) == 0; }));
  EXPECT_TRUE(kept().empty());
}

TEST_F(Uploads, TakeNoMemoryWhileTheyCome) {
  Tia tia(arguments());
  EXPECT_EQ(tia.get("/models").status, 200);
  const long before = kilobytes(tia, "VmHWM");
  constexpr std::size_t bytes = 60'000'000;
  Wire wire(tia.port());
  wire.send(head_of(bytes));
  const std::string some(1'000'000, ' ');
  for (std::size_t sent = 0; sent + some.size() < bytes; sent += some.size()) wire.send(some);
  EXPECT_TRUE(eventually([&] { return on_the_way(tia) > bytes - 2'000'000; }));
  EXPECT_LE(kilobytes(tia, "VmHWM") - before, (4 << 10) + sanitizers_kilobytes());
  RecordProperty("kilobytes", static_cast<int>(kilobytes(tia, "VmHWM") - before));
}

// Those that are on their way count, too, and not for longer than that.
TEST_F(Uploads, BeyondWhatTheFolderMayHaveAre507) {
  Tia tia(arguments({"--max-data-bytes", "3000000"}));
  const std::string stl = long_stl(1'300'000);
  {
    Wire wire(tia.port());
    wire.send(head_of(2'100'000) + std::string(2'099'999, ' '));
    EXPECT_TRUE(eventually([&] { return on_the_way(tia) > 1'800'000; }));
    const auto refused = tia.client().Post("/models", stl, "model/stl");
    EXPECT_EQ(refused->status, 507) << refused->body;
    EXPECT_THAT(refused->body, testing::HasSubstr("TIA_MAX_DATA_BYTES"));
  }
  EXPECT_TRUE(eventually([&] { return on_the_way(tia) == 0; }));
  EXPECT_EQ(tia.client().Post("/models", stl, "model/stl")->status, 201);
}

}  // namespace
}  // namespace tia::test
