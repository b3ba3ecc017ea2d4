// The disk below the folder of kept models fails or is full. Who is told 201 has a model that is
// there afterwards; of all others nothing is left.
#include <signal.h>

#include <cerrno>
#include <filesystem>
#include <optional>

#include "server/stores/digest.h"
#include "tests/server/faults/faults_support.h"
#include "tests/server/model_support.h"

namespace tia::test {
namespace {

struct ModelDiskRow {
  BrokenCall how;
  int status = 0;         ///< of an upload meanwhile
  std::size_t bytes = 0;  ///< of the model, at least
};
constexpr std::size_t streamed = 1'100'000;  // it goes to the disk while it comes
std::string name_of(const ModelDiskRow& row) {
  return name_of(row.how) + (row.bytes > 0 ? "_streamed" : "");
}
void PrintTo(const ModelDiskRow& row, std::ostream* out) { *out << name_of(row); }

const ModelDiskRow model_disk_rows[] = {{{faults_write, ENOSPC}, 507},
                                        {{faults_write, EDQUOT}, 507},
                                        {{faults_write, EIO}, 503},
                                        {{faults_write, EINTR}, 201},
                                        {{faults_write, 0}, 201},
                                        {{faults_fsync, ENOSPC}, 507},
                                        {{faults_fsync, EIO}, 503},
                                        {{faults_linkat, EIO}, 503},
                                        {{faults_openat, EMFILE}, 503},
                                        {{faults_write, ENOSPC}, 507, streamed},
                                        {{faults_write, EIO}, 503, streamed},
                                        {{faults_write, 0}, 201, streamed},
                                        {{faults_fsync, EIO}, 503, streamed},
                                        {{faults_linkat, ENOSPC}, 507, streamed},
                                        {{faults_openat, EMFILE}, 503, streamed},
                                        {{faults_pread, EIO}, 503, streamed},
                                        {{faults_pread, 0}, 201, streamed}};

class BrokenModelDisk : public testing::TestWithParam<ModelDiskRow> {
 protected:
  BrokenModelDisk() {
    faults_.only_below(std::filesystem::path(folder_.file("x")).parent_path());
    start();
  }
  void start() {
    tia_.emplace(Process::Words{"--port", "0", "--data-dir", folder_.file("")},
                 faults_.environment());
  }
  void restart() {
    tia_->signal(SIGKILL);
    tia_->wait();
    tia_.reset();
    start();
  }
  static std::string model(const std::string& name) {
    return stl_text(name + std::string(GetParam().bytes, ' '));
  }
  int post(const std::string& name) {
    const std::string text = model(name);
    return exchange(tia_->port(), "POST /models HTTP/1.1\r\nHost: x\r\nContent-Length: " +
                                      std::to_string(text.size()) + "\r\n\r\n" + text)
        .status;
  }
  int get(const std::string& name) {
    return tia_->get("/models/" + sha256_hex(model(name))).status;
  }
  std::ptrdiff_t files() const {
    return std::distance(std::filesystem::directory_iterator(folder_.file("models")),
                         std::filesystem::directory_iterator());
  }

  Faults faults_;
  Folder folder_;
  std::optional<Tia> tia_;
};

// Each time that the call comes, one upload a time; the last one meets it no more.
TEST_P(BrokenModelDisk, OnceAtAnyMomentLosesNothingAndLeavesNothing) {
  std::ptrdiff_t kept = 0;
  long n = 1;
  for (bool failed = true; failed && n < 20; ++n) {
    SCOPED_TRACE(n);
    const std::string name = "part" + std::to_string(n);
    faults_.once(GetParam().how, n);
    const int status = post(name);
    failed = faults_.failed() > 0;
    faults_.end();
    EXPECT_EQ(status, failed ? GetParam().status : 201);
    if (GetParam().bytes == 0 || status == 201) restart();
    // A folder that could not be synced may have the file all the same, and then it is whole.
    const int there = get(name);
    EXPECT_TRUE(status != 201 || there == 200);
    kept += there == 200 ? 1 : 0;
    EXPECT_EQ(files(), kept);
  }
  EXPECT_GT(n, 2);
}

INSTANTIATE_TEST_SUITE_P(Of, BrokenModelDisk, testing::ValuesIn(model_disk_rows),
                         [](const auto& one) { return name_of(one.param); });

}  // namespace
}  // namespace tia::test
