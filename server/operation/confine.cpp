#include <seccomp.h>
#include <sys/mman.h>
#include <sys/resource.h>

#include <array>
#include <cerrno>
#include <memory>
#include <system_error>

#include "server/operation/confined.h"

namespace tia::server {
namespace {

void set_limit(decltype(RLIMIT_AS) which, rlim_t soft, rlim_t hard) {
  const rlimit limit{soft, hard};
  if (setrlimit(which, &limit) != 0)
    throw std::system_error(errno, std::generic_category(), "setrlimit");
}

#ifndef TIA_SANITIZED

struct Release {
  void operator()(void* filter) const { seccomp_release(filter); }
};

void must(int result) {
  if (result != 0) throw std::system_error(-result, std::generic_category(), "seccomp");
}

// All that memory, sums and an answer take.
void allow_only_answering() {
  const std::unique_ptr<void, Release> filter(seccomp_init(SCMP_ACT_KILL_PROCESS));
  if (!filter) throw std::system_error(ENOSYS, std::generic_category(), "seccomp");
  const auto allow = [&](int call) {
    must(seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, 0, nullptr));
  };
  const auto allow_where = [&](int call, unsigned argument, std::uint64_t mask, std::uint64_t is) {
    const scmp_arg_cmp where{argument, SCMP_CMP_MASKED_EQ, mask, is};
    must(seccomp_rule_add_array(filter.get(), SCMP_ACT_ALLOW, call, 1, &where));
  };
  constexpr std::uint64_t whole = ~std::uint64_t{0};
  allow_where(SCMP_SYS(read), 0, whole, 0);
  allow_where(SCMP_SYS(write), 0, whole, 1);
  allow_where(SCMP_SYS(mmap), 3, MAP_ANONYMOUS, MAP_ANONYMOUS);
  for (const int call :
       {SCMP_SYS(munmap), SCMP_SYS(mremap), SCMP_SYS(brk), SCMP_SYS(madvise), SCMP_SYS(futex),
        SCMP_SYS(exit), SCMP_SYS(exit_group), SCMP_SYS(rt_sigreturn)})
    allow(call);
  must(seccomp_load(filter.get()));
}

#endif

}  // namespace

void confine(const Confinement& confinement) {
  set_limit(RLIMIT_CPU, confinement.cpu_s, confinement.cpu_s + 1);  // first SIGXCPU, then SIGKILL
#ifndef TIA_SANITIZED
  set_limit(RLIMIT_AS, confinement.memory_bytes, confinement.memory_bytes);
  for (const auto none : {RLIMIT_FSIZE, RLIMIT_CORE, RLIMIT_NPROC}) set_limit(none, 0, 0);
  set_limit(RLIMIT_NOFILE, 3, 3);
  allow_only_answering();
#endif
}

}  // namespace tia::server
