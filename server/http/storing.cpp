// The part of a connection that puts long bodies away as they come. The disk may keep whoever
// writes waiting: so that is a thread of its own.
#include <memory>
#include <new>
#include <string>

#include "server/http/connection.h"
#include "server/http/error.h"

namespace tia::server {

// Until the portion is away nothing more is read: who sends faster than the disk takes it waits.
void Connection::store() {
  const auto portion = std::make_shared<const std::string>(reader_.take_portion());
  const std::shared_ptr<LongBody> body = reader_.request().long_body;
  context_.writer.post([self = shared_from_this(), body, portion] {
    std::exception_ptr failure;
    try {
      body->append(*portion);
    } catch (...) {
      failure = std::current_exception();
    }
    self->context_.tell([self, failure] { self->go_on_reading(failure); });
  });
  storing_ = portion->capacity();
  stored_from_ = Clock::now();
  due_ = stored_from_ + context_.options.deadline;
}

void Connection::go_on_reading(const std::exception_ptr& failure) {
  storing_ = 0;
  if (phase_ != Phase::reading) return;
  since_ += Clock::now() - stored_from_;  // who sends is not held to the disk's time
  try {
    if (failure) refuse(failure);
    proceed();
  } catch (const std::bad_alloc&) {
    run_dry();
  }
}

// Whose fault it is that a request takes too long to come.
std::exception_ptr Connection::lateness() const {
  if (storing_ == 0) return failure("slow", "a head must come within 5 s, a body at 64 KiB/s");
  return failure("storage", "the disk takes too long for what is sent (option TIA_DEADLINE_MS)",
                 {{"Retry-After", std::to_string(context_.application.retry_after())}});
}

}  // namespace tia::server
