// The program itself over a C library whose calls fail when a test wants them to (tests/faults).
#pragma once

#include <string>
#include <vector>

#include "tests/faults/faults.h"
#include "tests/server/process_support.h"

namespace tia::test {

/// BrokenCall: which call goes wrong, and how.
struct BrokenCall {
  faults_call call;
  int error = 0;  ///< errno; 0 = it moves one byte where it may move more
};
/// "recv EINTR"
std::string name_of(const BrokenCall& how);
inline void PrintTo(const BrokenCall& how, std::ostream* out) { *out << name_of(how); }

/// Faults: what a program is started with to be broken, and breaks it.
class Faults {
 public:
  static constexpr long ever = 1L << 60;

  Faults();
  ~Faults();
  Faults(const Faults&) = delete;
  Faults& operator=(const Faults&) = delete;

  /// What stands in the environment of a program that can be broken.
  Process::Words environment() const;
  /// Breaks the call from its first-th time on to the last-th, each every-th time.
  void begin(const BrokenCall& how, long first = 1, long last = ever, long every = 1);
  /// Only its n-th time.
  void once(const BrokenCall& how, long n) { begin(how, n, n); }
  /// Only for files below the folder, from now on; "" = for all.
  void only_below(const std::string& folder);
  void end();
  /// How often the call has failed since it was broken.
  long failed() const;

 private:
  Folder folder_;
  faults* shared_;
};

}  // namespace tia::test
