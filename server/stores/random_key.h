// Names that nobody guesses.
#pragma once

#include <string>

namespace tia::server {

/// 128 bits of the system's randomness, in hexadecimal digits. Errors: StorageError.
std::string random_key();

}  // namespace tia::server
