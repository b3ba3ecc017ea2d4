// `tia render --job`: a job's parts without a server, for whoever starts commands on many machines.
#pragma once

#include <optional>
#include <string>

#include "server/operation/config.h"

namespace tia::server {

/// Draws a part of the job that a file tells of into FOLDER/N.part, or, without a number, says how
/// many there are. Its windows are of one size on every machine. Errors: InputError;
/// std::runtime_error for files.
void draw_job_part(const std::string& file, std::optional<int> part, const std::string& folder,
                   const Config& config);
/// The number that a scheduler's environment tells: SLURM_ARRAY_TASK_ID, JOB_COMPLETION_INDEX.
/// Errors: std::invalid_argument of what is no number.
std::optional<int> part_of_environment();
/// Puts the parts of a folder together, to a file; those of several pictures become an archive.
/// Errors: InputError; std::runtime_error for files, and for parts that are not there.
void join_job(const std::string& file, const std::string& folder, const std::string& output,
              const Config& config);

}  // namespace tia::server
