// What threads that share the work of a call carry over from the caller's thread.
#pragma once

namespace tia {

/// Whatever the caller has put there; core only hands it on. The server points it at the memory
/// claim of the request that the thread works for.
constinit inline thread_local void* task_context = nullptr;

}  // namespace tia
