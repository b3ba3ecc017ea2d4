#include "tests/server/faults/faults_support.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstring>
#include <new>
#include <stdexcept>

namespace tia::test {
namespace {

constexpr int no_call = -1;

std::string library() {
  return (std::filesystem::canonical("/proc/self/exe").parent_path() / "libtia_faults.so").string();
}

}  // namespace

std::string name_of(const BrokenCall& how) {
  static constexpr std::array names = {
#define FAULTS_NAME(name) #name,
      FAULTS_CALLS(FAULTS_NAME)
#undef FAULTS_NAME
  };
  const char* const error = how.error == 0 ? "short" : ::strerrorname_np(how.error);
  return std::string(names[static_cast<std::size_t>(how.call)]) + "_" + error;
}

Faults::Faults() {
  const int file = ::open(folder_.file("faults").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  void* at = MAP_FAILED;
  if (file >= 0 && ::ftruncate(file, sizeof(faults)) == 0)
    at = ::mmap(nullptr, sizeof(faults), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  ::close(file);
  if (at == MAP_FAILED) throw std::runtime_error("cannot share faults with a program");
  shared_ = new (at) faults{};
  shared_->call = no_call;
}
Faults::~Faults() { ::munmap(shared_, sizeof(faults)); }

Process::Words Faults::environment() const {
  return {"LD_PRELOAD=" + library(), FAULTS_FILE "=" + folder_.file("faults")};
}

void Faults::begin(const BrokenCall& how, long first, long last, long every) {
  end();
  shared_->error = how.error;
  shared_->first = first;
  shared_->last = last;
  shared_->every = every;
  std::atomic_ref(shared_->came) = 0;
  std::atomic_ref(shared_->failed) = 0;
  std::atomic_ref(shared_->call) = static_cast<int>(how.call);
}

void Faults::only_below(const std::string& folder) {
  end();
  std::memset(shared_->folder, 0, sizeof shared_->folder);
  folder.copy(shared_->folder, sizeof shared_->folder - 1);
}

void Faults::end() { std::atomic_ref(shared_->call) = no_call; }
long Faults::failed() const { return std::atomic_ref(shared_->failed); }

}  // namespace tia::test
