// How a test says which faults an input must be refused with.
#pragma once

#include <gmock/gmock.h>

#include <functional>

#include "core/input/errors.h"
#include "core/input/json.h"
#include "core/scene/read_scene.h"

namespace tia::test {

/// The faults that f throws as an InputError; none where it throws nothing.
inline std::vector<Fault> faults_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

/// A fault as a test expects it. `got` as canonical JSON; "" where nothing came.
struct Expected {
  FaultKind kind;
  std::string pointer, got;
  std::string allowed;  ///< a part of the fault's words
  std::string nearest = {};
};

/// Checks that exactly these faults come, in this order.
inline void expect_faults(const std::vector<Fault>& got, const std::vector<Expected>& expected) {
  ASSERT_EQ(got.size(), expected.size()) << [&] {
    std::string all;
    for (const Fault& fault : got) all += describe(fault) + "\n";
    return all;
  }();
  for (std::size_t i = 0; i < got.size(); ++i) {
    EXPECT_EQ(got[i].kind, expected[i].kind) << describe(got[i]);
    EXPECT_EQ(got[i].pointer, expected[i].pointer) << describe(got[i]);
    EXPECT_EQ(got[i].got ? to_json(*got[i].got) : "", expected[i].got) << describe(got[i]);
    EXPECT_THAT(got[i].allowed, testing::HasSubstr(expected[i].allowed)) << describe(got[i]);
    EXPECT_EQ(got[i].nearest, expected[i].nearest) << describe(got[i]);
  }
}

/// A check that texts are refused by a reader with exactly those faults: check(text, faults).
template <class Read>
auto refusal_by(Read read) {
  return [read](const std::string& text, const std::vector<Expected>& expected) {
    SCOPED_TRACE(text.substr(0, 200));
    expect_faults(faults_of([&] { read(text); }), expected);
  };
}

/// Checks that a scene is refused with exactly these faults.
inline const auto expect_scene_refused =
    refusal_by([](const std::string& json) { read_scene(json); });

}  // namespace tia::test
