// From where one may ask at all: not under a name that is not this server's, nor with a write that
// a page of another site has a browser send.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/http/message.h"
#include "server/http/peers.h"

namespace tia::server {

struct Config;

/// Errors: HttpError: misdirected (421) for a Host that is none of TIA_HOSTS, against DNS
/// rebinding: a page whose own name has been made to lead here; forbidden (403) for what is no GET,
/// HEAD or OPTIONS and comes from another origin that CORS does not name. /healthz and /readyz are
/// open: they tell nothing, and balancers ask them by whatever name. Source: W3C Fetch Metadata
/// (Sec-Fetch-Site); RFC 6454, 7 (Origin); RFC 9110, 15.5.20 (421).
void check_sites(const Request& request, const Config& config);

/// Whether only this machine can ask a server of that name or address.
bool is_loopback(const std::string& host);

}  // namespace tia::server
