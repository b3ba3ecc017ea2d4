// What tests of jobs share: jobs that are asked for, and waited for.
#pragma once

#include <thread>

#include "server/jobs/jobs.h"
#include "tests/server/socket_support.h"

namespace tia::test {

/// The id of the job that a 202 tells of.
inline std::string job_id(const Response& response) {
  EXPECT_EQ(response.status, 202) << response.body;
  const auto location = header(response, "Location");
  EXPECT_TRUE(location && location->starts_with("/jobs/")) << response.body;
  return location ? location->substr(6) : "";
}
inline std::string job_id(Host& host, const std::string& job) {
  return job_id(host.post("/jobs", job));
}
inline std::string state_of(Host& host, const std::string& id) {
  return text_at(parse_json(host.get("/jobs/" + id).body), "state");
}
/// Waits until it has ended. Returns: its state.
inline std::string ended(Host& host, const std::string& id) {
  std::string state;
  EXPECT_TRUE(eventually(
      [&] {
        state = state_of(host, id);
        return state != "queued" && state != "running";
      },
      seconds(60)))
      << id;
  return state;
}
/// The result of a job that ends well.
inline Response result_of(Host& host, const std::string& id) {
  EXPECT_EQ(ended(host, id), "done") << host.get("/jobs/" + id).body;
  return host.get("/jobs/" + id + "/result");
}

}  // namespace tia::test
