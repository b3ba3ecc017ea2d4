// The kinds of stores that jobs are kept in, for tests whose text is the same for all.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "server/jobs/store.h"
#include "tests/server/process_support.h"

namespace tia::test {

/// StoreKind: how a store is opened in a folder of the test's own.
struct StoreKind {
  std::string name;
  bool takes_up = false;  ///< a new one takes up what its last process was at
  std::function<std::unique_ptr<JobStore>(const Folder&, const JobLimits&, TimeMs now)> open;
  std::string lacks = {};  ///< the program that it needs and that is not here
};
inline void PrintTo(const StoreKind& kind, std::ostream* out) { *out << kind.name; }

/// JobStoreOf: a store of each kind, with jobs of so many parts.
class JobStoreOf : public testing::TestWithParam<StoreKind> {
 protected:
  static constexpr TimeMs keep_ms = 1000;

  void SetUp() override {
    if (!GetParam().lacks.empty()) GTEST_SKIP() << GetParam().lacks << " is not installed";
    open();
  }
  void open() {
    store.reset();
    store = GetParam().open(folder, limits, now);
  }
  static NewJob job(const std::string& id, int parts, const std::string& owner = "a") {
    return {.id = id, .owner = owner, .kind = "batch", .request = "{}", .parts = parts};
  }
  std::string finish_next() {
    const auto claim = store->claim("w", now);
    if (!claim) return "";
    store->finish(*claim, {.bytes = "x"}, now);
    return claim->job;
  }
  Folder folder;
  JobLimits limits{.tries = 3, .unfinished = 1000, .bytes = 1 << 24, .keep_ms = keep_ms};
  TimeMs now = 1'000'000;
  std::unique_ptr<JobStore> store;
};

}  // namespace tia::test
