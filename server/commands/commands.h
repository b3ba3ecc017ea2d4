// The list of commands. One more is its file, a declaration here and its name in the list.
#pragma once

#include "server/commands/command_line.h"

namespace tia::server {

void add_serve(CommandLine& line);
void add_worker(CommandLine& line);
void add_render(CommandLine& line);
void add_film(CommandLine& line);
void add_simulate(CommandLine& line);
void add_radio(CommandLine& line);
void add_scenes(CommandLine& line);
void add_still(CommandLine& line);
void add_model(CommandLine& line);
void add_job(CommandLine& line);
void add_key(CommandLine& line);
void add_sign(CommandLine& line);
void add_read_model(CommandLine& line);

/// In the order in which --help names them.
inline constexpr void (*commands[])(CommandLine&) = {
    add_serve, add_worker, add_render, add_film, add_simulate, add_radio,     add_scenes,
    add_still, add_model,  add_job,    add_key,  add_sign,     add_read_model};

}  // namespace tia::server
