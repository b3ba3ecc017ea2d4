#include "server/handlers/route_table.h"

#include "server/handlers/handlers.h"

namespace tia::server {

// One line an endpoint group; its rows stand beside its handlers.
const std::vector<Route>& routes() {
  static const std::vector<Route> table = [] {
    std::vector<Route> all;
    for (const auto group :
         {render_routes, film_routes, live_routes, picture_routes, verify_routes, explain_routes,
          compare_routes, scene_routes, simulate_routes, radio_routes, map_routes,
          gallery_model_routes, model_routes, still_routes, job_routes, operation_routes,
          document_routes, page_routes}) {
      const std::vector<Route> rows = group();
      all.insert(all.end(), rows.begin(), rows.end());
    }
    return all;
  }();
  return table;
}

}  // namespace tia::server
