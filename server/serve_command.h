// `tia serve`: config -> server -> wait for a signal -> drain.
#pragma once

#include "server/operation/config.h"

namespace tia::server {

/// Serves until SIGTERM or SIGINT, then finishes what has come. A second signal ends at once. Where
/// there is a file of keys, SIGHUP has it read anew.
/// Errors: std::runtime_error if the address, the threads or the file of kept scenes cannot be had;
/// std::invalid_argument of the files of keys.
void serve(const Config& config);

/// Whether a server with this configuration answers on this machine.
bool is_healthy(const Config& config);

}  // namespace tia::server
