// Models that come as a request's body, for all routes that take one.
#pragma once

#include <string>
#include <vector>

#include "server/contract/contract.h"
#include "server/handlers/service.h"
#include "server/http/head.h"
#include "server/http/message.h"

namespace tia::server {

/// How long a body that is a model may be.
BodyLimit model_limit(const Config& config);

/// SentId: the id of the model that a body is, which is kept now.
struct SentId {
  std::string id;
  ModelStore::Kept kept;
};
/// Reads the body as a model's files and keeps them. `main`: which of them is the model.
/// Domain: a body within the limit. Errors: as model_in, ModelStore::keep.
SentId keep_sent_model(const Request& request, const std::string& main, Service& service);

/// The bodies that it takes, as the documents have them.
std::vector<Content> model_bodies();

}  // namespace tia::server
