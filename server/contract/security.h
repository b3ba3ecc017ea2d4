// How the OpenAPI document tells of keys and signed URLs.
// Source: OpenAPI Specification 3.1.0, 4.8.27 and 4.8.30.
#pragma once

#include "server/contract/route.h"

namespace tia::server {

/// What a request may come with, one of these: a key; of GET the three parameters of a signed URL;
/// or nothing, where the operator lets anybody. Each with the rights that it needs.
Value::Array security_array(const Route& route);

/// What these ways are.
Value security_schemes();

}  // namespace tia::server
