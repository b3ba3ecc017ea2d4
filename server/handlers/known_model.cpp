#include "server/handlers/known_model.h"

#include "core/version.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/requests/etag.h"
#include "server/stores/digest.h"
#include "server/stores/gallery_models.h"

namespace tia::server {
namespace {

HttpError no_model() {
  return {"not-found", "no model is called that; there are: " + listed(gallery_model_names()) +
                           ", and those sent to POST /models, by their ids"};
}

std::string tag_of(const Request& request, const std::string& name) {
  const GalleryModel* const model = gallery_model(name);
  const std::string& id = model == nullptr ? name : model->id;
  return '"' + sha256_hex(std::string(request.path()) + ' ' + id + ' ' + version()) + '"';
}

}  // namespace

Response told_of_model(const Request& request, const std::string& name, Service& service,
                       const std::function<std::string(const KnownModel&)>& tell) {
  if (!service.models.contains(name)) throw no_model();
  const std::string tag = tag_of(request, name);
  Response response{.content_type = "application/json",
                    .body = "",
                    .headers = {{"ETag", tag}, {"Cache-Control", "no-cache"}}};
  if (has_already(request, tag)) {
    response.status = 304;
    response.content_type = "";
    return response;
  }
  response.unsized = request.is_head();
  if (response.unsized) return response;
  const KnownModel known = service.models.find(name, requester_of(request));
  if (!known) throw no_model();  // it has made room for another just now
  response.body = tell(known);
  return response;
}

}  // namespace tia::server
