// `tia key` and `tia sign`: what an operator makes for others to ask with.
#pragma once

#include <string>

#include "server/operation/config.h"

namespace tia::server {

/// Makes a secret for the id and writes two lines to standard output: what to send after
/// `Authorization: Bearer `, which nobody can tell again, and the entry for TIA_KEYS_FILE.
/// Errors: std::invalid_argument of what is no id.
void print_new_key(const std::string& id);

/// Writes the URL, or its path and query, to standard output with a signature that ends so many
/// seconds from now, by the first line of TIA_SIGN_FILE.
/// Errors: std::invalid_argument of the file, of a URL that is none, has a fragment, is signed or
/// would be too long.
void print_signed_url(const std::string& url, double seconds, const Config& config);

}  // namespace tia::server
