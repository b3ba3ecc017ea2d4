#include "server/requests/reached.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

#include "server/contract/parameters.h"
#include "server/http/error.h"

namespace tia::server {

void tell_reached(const Reached& reached, Headers& headers) {
  char samples[96], noise[16];
  std::snprintf(samples, sizeof samples, "min=%d, mean=%.1f, max=%d", reached.least, reached.mean,
                reached.most);
  std::snprintf(noise, sizeof noise, "%.6f", reached.noise);
  headers.emplace_back("Tia-Samples", samples);
  headers.emplace_back("Tia-Noise", noise);
}

std::string address_of_reached(const Request& request, int samples) {
  if (request.method == "POST") return "";
  std::string query;
  std::string_view left = request.query();
  while (!left.empty()) {
    const std::string_view each = left.substr(0, left.find('&'));
    left.remove_prefix(std::min(left.size(), each.size() + 1));
    QueryReader one(each);
    if (!one.next()) continue;
    if (one.name() != "budget_ms" && one.name() != "max_rays" && one.name() != "samples")
      query.append(each).append("&");
  }
  std::string address = "/render?" + query + "samples=" + std::to_string(samples);
  return address.size() < longest_target ? address : "";
}

}  // namespace tia::server
