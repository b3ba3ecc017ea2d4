// Files of the command line's.
#pragma once

#include <string>

namespace tia::server {

/// Errors: std::runtime_error naming it.
std::string read_file(const std::string& name);
/// To standard output where the name is "-". What cannot be written whole is removed.
/// Errors: std::runtime_error naming it.
void write_file(const std::string& name, const std::string& bytes);
/// Puts it in a file's place at once, so that whoever reads that finds one of the two whole.
/// Domain: a file beside which there may be another, NAME.part. Errors: as write_file.
void replace_file(const std::string& name, const std::string& bytes);

}  // namespace tia::server
