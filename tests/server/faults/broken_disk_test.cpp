// R17: the disk below the file of kept scenes fails or is full, for a while or once at any moment.
// Who is told 201 has a scene that is there afterwards; nobody else is told so.
#include <signal.h>

#include <cerrno>
#include <map>
#include <optional>
#include <utility>

#include "server/stores/digest.h"
#include "server/stores/scene_file.h"
#include "tests/server/faults/faults_support.h"

namespace tia::test {
namespace {

/// Bytes of a scene's title: one page of the file, many, and more than its journal keeps.
constexpr std::size_t one_page = 10, many_pages = 600'000, long_journal = 9'000'000;

/// A server whose kept scenes are in a folder that can be broken, and what it has said of them.
class Disk {
 public:
  Disk() { faults_.only_below(std::filesystem::path(folder_.file("x")).parent_path()); }

  Faults& faults() { return faults_; }
  Tia& tia() { return *tia_; }
  // Memory holds none of the scenes: all that is served is read from the file.
  Process::Words arguments() const {
    return {"--port",           "0",        "--data-dir",         folder_.file(""),
            "--max-body-bytes", "16777216", "--max-scenes-bytes", "0",
            "--cache-bytes",    "0"};
  }
  void start() { tia_.emplace(arguments(), faults_.environment()); }
  void end(int signal) {
    tia_->signal(signal);
    tia_->wait();
    tia_.reset();
  }

  /// A scene that has not been sent before.
  Response post_new(std::size_t bytes) {
    const std::string scene =
        "{\"title\":\"" + std::to_string(++count_) + std::string(bytes, 'x') + "\"}";
    return post(scene);
  }
  Response post(const std::string& scene) {
    const Response response =
        exchange(tia_->port(), "POST /scenes HTTP/1.1\r\nHost: x\r\nContent-Length: " +
                                   std::to_string(scene.size()) + "\r\n\r\n" + scene);
    const std::string id = sha256_hex(scene);
    if (response.status == 201) confirmed_[id] = scene;
    else refused_[id] = scene;
    return response;
  }
  Response get(const std::string& id) const { return tia_->get("/scenes/" + id); }

  void expect_confirmed() const {
    for (const auto& [id, scene] : confirmed_) {
      const Response response = get(id);
      ASSERT_EQ(response.status, 200) << response.body;
      ASSERT_TRUE(response.body == scene);
    }
  }
  void expect_others_missing() const {
    for (const auto& [id, scene] : refused_)
      ASSERT_EQ(get(id).status, confirmed_.count(id) == 0 ? 404 : 200);
  }
  void expect_all_can_be_kept() {
    for (const auto& [id, scene] : std::exchange(refused_, {})) EXPECT_EQ(post(scene).status, 201);
  }

 private:
  Faults faults_;
  Folder folder_;
  std::optional<Tia> tia_;
  std::map<std::string, std::string> confirmed_, refused_;  // by id
  int count_ = 0;
};

struct DiskRow {
  BrokenCall how;
  const char* type;  ///< of the problem; "" = the scene is kept all the same
};
void PrintTo(const DiskRow& row, std::ostream* out) { *out << name_of(row.how); }

const DiskRow disk_rows[] = {{{faults_pwrite, ENOSPC}, "storage-full"},
                             {{faults_pwrite, EIO}, "storage"},
                             {{faults_pwrite, EDQUOT}, "storage"},
                             {{faults_pwrite, 0}, ""},
                             {{faults_fdatasync, EIO}, "storage"},
                             {{faults_fdatasync, ENOSPC}, "storage"},
                             {{faults_ftruncate, EIO}, ""}};

class BrokenDisk : public testing::TestWithParam<DiskRow> {
 protected:
  // A file is cut only where the journal has grown long.
  static std::size_t first_bytes() {
    return GetParam().how.call == faults_ftruncate ? long_journal : many_pages;
  }

  Disk disk_;
};

TEST_P(BrokenDisk, RefusesWhatItCannotKeepAndServesWhatItHas) {
  const std::string type = GetParam().type;
  for (const int signal : {SIGTERM, SIGKILL}) {
    disk_.start();
    EXPECT_EQ(disk_.post_new(one_page).status, 201);
    EXPECT_EQ(disk_.post_new(first_bytes()).status, 201);
    disk_.faults().begin(GetParam().how, 1, Faults::ever, GetParam().how.error == 0 ? 50 : 1);
    for (const std::size_t bytes : {one_page, many_pages, one_page}) {
      const Response response = disk_.post_new(bytes);
      if (type.empty()) {
        EXPECT_EQ(response.status, 201) << response.body;
      } else {
        EXPECT_EQ(response.status, type == "storage" ? 503 : 507);
        EXPECT_EQ(problem_of(response).type, "/problems/" + type);
      }
    }
    disk_.expect_confirmed();
    disk_.expect_others_missing();
    EXPECT_EQ(disk_.tia().get("/render?width=8&height=8").status, 200);
    EXPECT_GT(disk_.faults().failed(), 0);
    disk_.faults().end();
    EXPECT_EQ(disk_.post_new(one_page).status, 201);
    disk_.end(signal);
    disk_.start();
    disk_.expect_confirmed();
    disk_.expect_others_missing();
    disk_.expect_all_can_be_kept();
    disk_.expect_confirmed();
    disk_.end(signal);
  }
}

TEST_P(BrokenDisk, OnceAtAnyMomentLosesNothingThatIsConfirmed) {
  disk_.start();
  disk_.post_new(first_bytes());
  long n = 1;
  for (bool failed = true; failed && n < 3000 && !HasFailure(); n += 1 + n / 2) {
    SCOPED_TRACE(n);
    disk_.faults().once(GetParam().how, n);
    const Response response = disk_.post_new(many_pages);
    failed = disk_.faults().failed() > 0;
    disk_.faults().end();
    if (response.status != 201) {
      EXPECT_TRUE(failed);
      EXPECT_EQ(problem_of(response).type, std::string("/problems/") + GetParam().type);
    }
    EXPECT_EQ(disk_.post_new(one_page).status, 201);
  }
  EXPECT_GT(n, 2);
  disk_.end(SIGKILL);
  disk_.start();
  disk_.expect_confirmed();
  disk_.expect_others_missing();
}

INSTANTIATE_TEST_SUITE_P(Of, BrokenDisk, testing::ValuesIn(disk_rows),
                         [](const auto& one) { return name_of(one.param.how); });

// ---- while it starts ------------------------------------------------------------------------

const BrokenCall opening[] = {
    {faults_open, EMFILE},   {faults_open, EACCES},   {faults_pread, EIO},
    {faults_pread, 0},       {faults_pwrite, ENOSPC}, {faults_pwrite, EIO},
    {faults_fdatasync, EIO}, {faults_ftruncate, EIO}, {faults_fcntl, ENOLCK},
    {faults_fstat, EIO},     {faults_mmap, ENOMEM},   {faults_close, EIO},
    {faults_unlink, EACCES}};

class BrokenDiskAtStart : public testing::TestWithParam<BrokenCall> {
 protected:
  // Serves, or names the file and leaves. Returns: whether a call failed.
  bool starts_or_says_why() {
    Process tia(disk_.arguments(), disk_.faults().environment());
    const auto has_spoken = [&] { return tia.out().find('\n') != std::string::npos; };
    EXPECT_TRUE(eventually([&] { return has_spoken() || !tia.running(); }));
    tia.signal(SIGTERM);
    const Finished end = tia.wait();
    if (end.status != 0) {
      EXPECT_EQ(end.status, 2);
      EXPECT_THAT(end.err, testing::StartsWith("tia: option TIA_DATA_DIR: "));
    }
    const bool failed = disk_.faults().failed() > 0;
    disk_.faults().end();
    return failed;
  }

  Disk disk_;
};

// Each time after a crash, so that there is a journal to be read.
TEST_P(BrokenDiskAtStart, IsAStartOrAWordOfWhatIsWrongAndLosesNothing) {
  long n = 1;
  for (bool failed = true; failed && n < 1000 && !HasFailure(); n += 1 + n / 4) {
    SCOPED_TRACE(n);
    disk_.start();
    disk_.expect_confirmed();
    EXPECT_EQ(disk_.post_new(one_page).status, 201);
    disk_.end(SIGKILL);
    disk_.faults().once(GetParam(), n);
    failed = starts_or_says_why();
  }
  // The thread sanitizer's own fstat stands before the one that fails.
  const bool hidden = __tsan_init != nullptr && name_of(GetParam()).starts_with("fstat");
  EXPECT_GT(n, hidden ? 1 : 2);
  disk_.start();
  disk_.expect_confirmed();
}

INSTANTIATE_TEST_SUITE_P(Of, BrokenDiskAtStart, testing::ValuesIn(opening),
                         [](const auto& one) { return name_of(one.param); });

}  // namespace
}  // namespace tia::test
