// `tia serve`: config -> server -> wait for a signal -> drain.
#pragma once

#include "server/operation/config.h"

namespace tia::server {

/// Serves until SIGTERM or SIGINT, then finishes what has come. A second signal ends at once.
/// Errors: std::runtime_error if the address, the threads or the file of kept scenes cannot be had.
void serve(const Config& config);

/// Whether a server with this configuration answers on this machine.
bool is_healthy(const Config& config);

}  // namespace tia::server
