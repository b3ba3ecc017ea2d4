// Work that goes through a long text or a large scene and cannot be shared among threads: with a
// ticket, a claim on memory, and a turn among the threads that trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <utility>

#include "core/parallel/pool.h"
#include "server/operation/admission.h"
#include "server/operation/requester.h"

namespace tia::server {

class LongWork {
 public:
  LongWork(Admission& admission, Pool& pool) : admission_(admission), pool_(pool) {}

  struct Need {
    std::size_t bytes = 0;    ///< that it goes through: long ones a few at a time
    std::int64_t memory = 0;  ///< that it may take at most
    std::string_view what;    ///< for words
  };
  /// Does it, and gives back what memory it has not in use. Domain: it waits for nothing.
  /// Returns: what it does. Errors: HttpError (busy, too-large); Stopped; whatever it throws.
  template <class Work>
  auto operator()(const Need& need, const Requester& requester, const Work& work) {
    std::optional<decltype(work())> made;
    run(need, requester, [&] { made.emplace(work()); });
    return std::move(*made);
  }

 private:
  void run(const Need& need, const Requester& requester, const std::function<void()>& work);

  Admission& admission_;
  Pool& pool_;
};

}  // namespace tia::server
