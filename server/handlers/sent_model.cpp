#include "server/handlers/sent_model.h"

#include <algorithm>

#include "core/models/formats.h"
#include "server/handlers/bodies.h"
#include "server/requests/model_body.h"

namespace tia::server {
namespace {

// In the places of long texts, however short it is: an archive has a process.
LongWork::Need files_need(const Request& request) {
  const std::size_t bytes = request.body_bytes();
  const std::size_t from_disk = request.long_body ? bytes : 0;
  return {std::max(bytes, Admission::longest_short_text + 1),
          memory_for(memory_cost::model, bytes) + static_cast<std::int64_t>(from_disk),
          "the model's files"};
}

}  // namespace

BodyLimit model_limit(const Config& config) {
  return {config.max_model_bytes, "TIA_MAX_MODEL_BYTES"};
}

SentId keep_sent_model(const Request& request, const std::string& main, Service& service) {
  const Requester requester = requester_of(request);
  const SentModel sent = service.rendering.long_work(files_need(request), requester, [&] {
    return model_in(request, main, 4 * service.config.max_model_bytes, service.models);
  });
  return {sent.upload.id, service.models.keep(sent.upload, requester)};
}

std::vector<Content> model_bodies() {
  return {{"application/octet-stream"},
          {"multipart/form-data"},
          {"application/zip"},
          {"model/gltf-binary"},
          {"model/gltf+json"},
          {"model/obj"},
          {"model/stl"}};
}

}  // namespace tia::server
