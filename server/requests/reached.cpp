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

namespace {

// The request's with `says` in the place of those parameters.
std::string address_with(const Request& request, std::initializer_list<std::string_view> without,
                         const std::string& says) {
  if (request.method == "POST") return "";
  std::string address =
      std::string(request.path()) + "?" + query_without(request.query(), without) + says;
  return address.size() < longest_target ? address : "";
}

}  // namespace

std::string query_without(std::string_view left, std::initializer_list<std::string_view> names) {
  std::string query;
  while (!left.empty()) {
    const std::string_view each = left.substr(0, left.find('&'));
    left.remove_prefix(std::min(left.size(), each.size() + 1));
    QueryReader one(each);
    if (!one.next()) continue;
    if (std::find(names.begin(), names.end(), one.name()) == names.end())
      query.append(each).append("&");
  }
  return query;
}

std::string address_of_reached(const Request& request, int samples) {
  return address_with(request, {"budget_ms", "max_rays", "samples"},
                      "samples=" + std::to_string(samples));
}
std::string address_of_timed(const Request& request, std::int64_t gaze_rays) {
  return address_with(request, {"frame_ms", "gaze_rays", "v"},
                      "gaze_rays=" + std::to_string(gaze_rays));
}

}  // namespace tia::server
