#include "server/requests/find_model.h"

namespace tia::server {

SharedModel find_model(const std::string& id, const RenderContext& context,
                       const Requester& requester) {
  if (context.models == nullptr || !is_model_id(id)) return nullptr;
  return context.models->find(id, requester).model;
}

}  // namespace tia::server
