// Memory that runs out when it is told to: every allocation of this program, its libraries' as
// well, comes through here.
#pragma once

namespace tia::test {

enum class Shortage { once, lasting };

/// Lets the n-th allocation from now on fail, by any thread, or all from the n-th on.
void run_out_of_memory(long n, Shortage shortage);

/// Ends the shortage. Returns: whether an allocation has failed.
bool end_shortage();

/// Allocations since the last call of run_out_of_memory.
long allocations();

/// Pieces of memory that have been allocated and not freed.
long live_pieces();

/// What they take together, with what the C library adds to each, in bytes.
long live_bytes();
/// The most that was since the last call.
long take_peak_bytes();

}  // namespace tia::test
