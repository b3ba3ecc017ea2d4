// Files of the command line's.
#pragma once

#include <string>

namespace tia::server {

/// Errors: std::runtime_error naming it.
std::string read_file(const std::string& name);
/// To standard output where the name is "-". What cannot be written whole is removed.
/// Errors: std::runtime_error naming it.
void write_file(const std::string& name, const std::string& bytes);

}  // namespace tia::server
