#include "server/access/sites.h"

#include <algorithm>
#include <string_view>

#include "server/http/error.h"
#include "server/http/headers.h"
#include "server/operation/config.h"

namespace tia::server {

// Not every name that begins with 127. is an address, nor is one with a zone behind it.
bool is_loopback(const std::string& host) {
  static const auto addresses = Network::parse("127.0.0.0/8");
  return host == "localhost" || host == "::1" || host == "[::1]" ||
         (host.find('%') == host.npos && addresses->contains(host));
}

namespace {

// A Host field without its port, in lower case.
std::string name_in(std::string_view host) {
  const auto bracket = host.find(']');
  const auto colon = host.find(':', bracket == host.npos ? 0 : bracket);
  return lower(host.substr(0, colon));
}

bool is_ours(const std::string& name, const Config& config) {
  if (!config.hosts.empty())
    return std::ranges::any_of(config.hosts, [&](const HostName& each) {
      return each.text == "*" || lower(each.text) == name;
    });
  return !is_loopback(config.host) || is_loopback(name) || name == lower(config.host);
}

bool is_safe(const std::string& method) {
  return method == "GET" || method == "HEAD" || method == "OPTIONS";
}

bool cors_names(std::string_view origin, const Config& config) {
  return std::ranges::any_of(config.cors_origins, [&](const Origin& each) {
    return each.is_any() || each.text == origin;
  });
}

// Whether the origin is the one that the request is sent to, whichever scheme a proxy has ended.
bool is_own(std::string_view origin, std::string_view host) {
  const auto scheme = origin.find("://");
  return scheme != origin.npos && lower(origin.substr(scheme + 3)) == lower(host);
}

bool is_foreign_write(const Request& request, const Config& config) {
  if (is_safe(request.method)) return false;
  const std::string_view site = request.header("Sec-Fetch-Site");
  if (site == "same-origin" || site == "none") return false;  // no page can claim that
  const std::string_view origin = request.header("Origin");
  if (origin.empty()) return site == "cross-site";
  return !is_own(origin, request.header("Host")) && !cors_names(origin, config);
}

}  // namespace

void check_sites(const Request& request, const Config& config) {
  const std::string_view host = request.header("Host");
  const bool is_probe = request.path() == "/healthz" || request.path() == "/readyz";
  if (!host.empty() && !is_probe && !is_ours(name_in(host), config))
    throw HttpError("misdirected",
                    "this server is not called " + excerpt_of(host, 80) + " (option TIA_HOSTS)");
  if (is_foreign_write(request, config))
    throw HttpError("forbidden",
                    "a page of another origin may not write here (option TIA_CORS_ORIGINS)");
}

}  // namespace tia::server
