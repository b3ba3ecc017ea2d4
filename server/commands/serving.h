// What `tia serve` and `tia worker` do: config -> server -> wait for a signal -> drain.
#pragma once

#include <string>

#include "server/operation/config.h"

namespace tia::server {

/// Serves until SIGTERM or SIGINT, then finishes what has come. A second signal ends at once. Where
/// there is a file of keys, SIGHUP has it read anew.
/// Errors: std::runtime_error if the address, the threads or the file of kept scenes cannot be had;
/// std::invalid_argument of the files of keys.
void serve(const Config& config);

/// Draws parts of the farm's jobs until SIGTERM or SIGINT; what has not ended TIA_DRAIN_MS later is
/// given back. A worker that has drawn other bytes than another one ends by itself.
/// Errors: as serve; std::invalid_argument naming what is wrong of the farm's options.
void work(Config config, const std::string& name);

/// Whether a server with this configuration answers on this machine.
bool is_healthy(const Config& config);

}  // namespace tia::server
