// Results of jobs that are kept in TIA_STORE, and what a store of jobs remembers of them.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "server/contract/problem.h"
#include "server/stores/blobs.h"

namespace tia::server {

/// The folder of that job's.
inline std::string results_folder(const std::string& id) { return "results/" + id + '/'; }

/// Puts it under a name that only this has. Returns: what tells of it, "NAME SHA256 BYTES".
/// Errors: Blobs'.
std::string put_outside(Blobs& outside, const std::string& folder, const std::string& bytes);
/// What is told of, where it is as it was; else none. Errors: Blobs'.
std::optional<std::string> find_outside(Blobs& outside, const std::string& told);
/// Returns: whether it is gone; why it is not is logged.
bool remove_outside(Blobs& outside, const std::string& told);
/// Errors of who asks for a result that cannot be used.
StorageError damaged_result(const std::string& id, int n);
/// Removes what is in the folder but what is told of, until then. Returns: whether it has all of
/// it. Errors: Blobs'.
bool keep_alone(Blobs& outside, const std::string& folder, const std::vector<std::string>& told,
                std::chrono::steady_clock::time_point until);

}  // namespace tia::server
