// Whose word for a client's address is taken.
#pragma once

#include <functional>
#include <string>

#include "server/http/message.h"

namespace tia::server {

/// Whether the machine of that address is a proxy that tells the truth of whom it asks for.
using TrustsProxy = std::function<bool(const std::string&)>;

/// The client's address: the socket's; where that is a trusted proxy's, the last address in
/// X-Forwarded-For that is not, without a port. What is no address there is made up, and so is all
/// before it.
std::string client_address(const std::string& peer, const Headers& headers,
                           const TrustsProxy& trusts);

}  // namespace tia::server
