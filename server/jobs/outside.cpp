#include "server/jobs/outside.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "server/operation/log.h"
#include "server/stores/digest.h"
#include "server/stores/random_key.h"

namespace tia::server {
namespace {

std::string name_in(std::string_view told) { return std::string(told.substr(0, told.find(' '))); }

}  // namespace

std::string put_outside(Blobs& outside, const std::string& folder, const std::string& bytes) {
  const std::string sha256 = sha256_hex(bytes);
  const std::string name = folder + sha256 + '-' + random_key();
  outside.put(name, bytes);
  return name + ' ' + sha256 + ' ' + std::to_string(bytes.size());
}

std::optional<std::string> find_outside(Blobs& outside, const std::string& told) {
  const std::string name = name_in(told);
  return checked_blob(
      outside, name,
      std::string_view(told).substr(std::min(told.size(), name.size() + 1), 2 * Digest{}.size()));
}

bool remove_outside(Blobs& outside, const std::string& told) try {
  outside.remove(name_in(told));
  return true;
} catch (const std::exception& error) {
  log_failure("jobs", error.what());
  return false;
}

StorageError damaged_result(const std::string& id, int n) {
  return StorageError("result " + std::to_string(n) + " of the job " + id +
                      " is gone or damaged (option TIA_STORE)");
}

bool keep_alone(Blobs& outside, const std::string& folder, const std::vector<std::string>& told,
                std::chrono::steady_clock::time_point until) {
  std::set<std::string> needed;
  for (const std::string& each : told) needed.insert(name_in(each));
  for (const std::string& name : outside.names(folder)) {
    if (needed.contains(name)) continue;
    if (std::chrono::steady_clock::now() > until) return false;
    outside.remove(name);
  }
  return true;
}

}  // namespace tia::server
