// Models that are asked for by name or id, for all routes that tell of one.
#pragma once

#include <functional>
#include <string>

#include "server/handlers/service.h"
#include "server/http/message.h"
#include "server/stores/read_models.h"

namespace tia::server {

/// What tell() makes of the model of that name or id, JSON, with a tag; the tag alone where the
/// client has it or asks for nothing else. The tag is of the request's path, the model's file and
/// this version, which is all that decides the bytes: so it is known before anything is read.
/// Errors: HttpError (not-found); as ModelStore::find; whatever tell() throws.
Response told_of_model(const Request& request, const std::string& name, Service& service,
                       const std::function<std::string(const KnownModel&)>& tell);

}  // namespace tia::server
