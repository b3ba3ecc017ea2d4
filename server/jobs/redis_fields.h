// Jobs and parts as a farm keeps them: as fields of hashes, all of them text.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "server/jobs/job.h"
#include "server/stores/redis_reply.h"

namespace tia::server {

/// Fields and values of what is submitted, one after the other.
std::vector<std::string> redis_fields(const NewJob& job);
/// Of what a new plan decides.
std::vector<std::string> redis_plan_fields(const NewJob& job);
/// The job of HGETALL's answer. Errors: StorageError where it is none.
Job job_of(const RedisReply& fields);
/// A part by its row; of one without a row what nobody has begun.
PartRow part_of(int n, const RedisReply& row);

}  // namespace tia::server
