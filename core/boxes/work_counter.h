// WorkCounter: the work that tracing has taken so far.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

namespace tia {

/// WorkCounter: counts tests of boxes and surfaces, and reports their work in portions, so that it
/// can be limited even within one ray, which may be tried on a million things that overlap.
/// Space/units: work in tests of a box or a ball by a whole packet, or of a register of boxes
/// or balls or of a leaf of triangles by one ray; so its sum depends on how rays are packed.
class WorkCounter {
 public:
  /// Takes a portion of work; may throw, which ends the tracing.
  using Report = std::function<void(std::int64_t work)>;
  static constexpr std::int64_t portion = 1 << 16;

  /// One that only counts.
  WorkCounter() = default;
  explicit WorkCounter(Report report) : report_(std::move(report)) {}

  /// One test more. Errors: what the report throws.
  void test(std::int64_t work = 1) {
    beyond_ += work - 1;  // mostly 0, as the compiler sees
    left_ -= work;
    if (left_ <= 0) tell();
  }
  /// So many tests more. Errors: what the report throws.
  void tests(std::int64_t more) {
    left_ -= more;
    if (left_ <= 0) tell();
  }
  /// Adds what a test cost beyond what it was counted for. Errors: what the report throws.
  void add(std::int64_t work) {
    beyond_ += work;
    left_ -= work;
    if (left_ <= 0) tell();
  }
  std::int64_t tests() const { return told_ + (portion - left_) - beyond_; }

 private:
  [[gnu::noinline]] void tell() {
    const std::int64_t work = portion - std::exchange(left_, portion);
    told_ += work;
    if (report_) report_(work);
  }

  Report report_;
  std::int64_t left_ = portion;  // what the only instructions of most tests count down
  std::int64_t told_ = 0;
  std::int64_t beyond_ = 0;  // of all work, that which is not one for each test
};

}  // namespace tia
