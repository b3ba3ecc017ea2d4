// EventQueue: what is predicted to happen, the first on top. Predictions are not taken back: each
// carries the versions of its balls, which are counted up where a ball's predictions are made anew.
// Source: Lubachevsky, "How to Simulate Billiards and Similar Systems", J. Comput. Phys. 94 (1991).
#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

namespace tia {

struct MotionEvent {
  enum Kind : std::uint32_t { leaves, enters, meets_ball, meets_patch, slides, crosses };
  double time = 0;
  Kind kind = crosses;
  std::uint32_t ball = 0;
  std::uint32_t other = 0;  ///< a ball, a patch, the cell's face
  std::uint32_t version = 0, other_version = 0;

  friend bool operator<(const MotionEvent& a, const MotionEvent& b) {
    return std::tie(a.time, a.kind, a.ball, a.other) < std::tie(b.time, b.kind, b.ball, b.other);
  }
};

class EventQueue {
 public:
  bool empty() const { return heap_.empty(); }
  const MotionEvent& top() const { return heap_.front(); }
  std::size_t size() const { return heap_.size(); }
  void push(const MotionEvent& event) {
    heap_.push_back(event);
    std::push_heap(heap_.begin(), heap_.end(), later);
  }
  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    heap_.pop_back();
  }
  /// Drops what is no longer true.
  template <class IsTrue>
  void keep(IsTrue is_true) {
    std::erase_if(heap_, [&](const MotionEvent& event) { return !is_true(event); });
    std::make_heap(heap_.begin(), heap_.end(), later);
  }

 private:
  static bool later(const MotionEvent& a, const MotionEvent& b) { return b < a; }
  std::vector<MotionEvent> heap_;
};

}  // namespace tia
