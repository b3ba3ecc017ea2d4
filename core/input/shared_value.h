// SharedValue: a JSON value that its copies share.
#pragma once

#include <memory>
#include <utility>

#include "core/input/value.h"

namespace tia {

/// SharedValue: as a const Value, but a copy costs nothing however large it is. Threads may read
/// copies at once.
class SharedValue {
 public:
  SharedValue(Value value) : value_(std::make_shared<const Value>(std::move(value))) {}

  const Value& operator*() const { return *value_; }
  const Value* operator->() const { return value_.get(); }
  bool operator==(const SharedValue& other) const {
    return value_ == other.value_ || *value_ == *other.value_;
  }

 private:
  std::shared_ptr<const Value> value_;
};

}  // namespace tia
