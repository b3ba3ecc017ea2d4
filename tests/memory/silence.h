// Standard error without the log's lines, of which a sweep through all failures makes thousands.
#pragma once

#include <fcntl.h>
#include <unistd.h>

// A sanitizer's reports go where they are told, where the program has one.
extern "C" void __sanitizer_set_report_fd(void*) __attribute__((weak));

namespace tia::test {

/// Silence: while it lives, nothing but a sanitizer's reports is written to standard error.
class Silence {
 public:
  Silence() : error_(::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3)) {
    report_to(error_);
    const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    ::dup2(nowhere, STDERR_FILENO);
    ::close(nowhere);
  }
  ~Silence() {
    ::dup2(error_, STDERR_FILENO);
    report_to(STDERR_FILENO);
    ::close(error_);
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  static void report_to(long descriptor) {
    if (__sanitizer_set_report_fd != nullptr)
      __sanitizer_set_report_fd(reinterpret_cast<void*>(descriptor));
  }
  int error_;
};

}  // namespace tia::test
