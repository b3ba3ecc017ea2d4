#include "server/http/headers.h"

#include <algorithm>

namespace tia::server {
namespace {

// The page has no inline script and no inline style; its pictures are blobs of what it fetched.
constexpr const char* page_policy =
    "default-src 'none'; img-src 'self' blob: data:; script-src 'self'; style-src 'self'; "
    "connect-src 'self'; base-uri 'none'; frame-ancestors 'none'";

// What the page of another origin may know of an answer besides its body.
constexpr const char* exposed =
    "ETag, Server-Timing, Tia-Rays, Tia-Delete-Key, X-Request-Id, traceparent, Retry-After, "
    "Cache-Status, Content-Location, Tia-Samples, Tia-Noise, Tia-Biased, Tia-Ignored, "
    "WWW-Authenticate, RateLimit-Policy, RateLimit";
constexpr const char* preflight_seconds = "7200";  // the longest that Chromium remembers

bool is_document(std::string_view type) {
  return type.starts_with("text/html") || type == "image/svg+xml";
}

// What pages show in an <img>.
bool is_shown_picture(std::string_view type) {
  return type.starts_with("image/") || type.starts_with("multipart/x-mixed-replace");
}

bool allows_any(const std::vector<Origin>& origins) {
  return std::any_of(origins.begin(), origins.end(), [](const Origin& o) { return o.is_any(); });
}

std::string* find_header(Headers& headers, std::string_view name) {
  for (auto& [key, value] : headers)
    if (key == name) return &value;
  return nullptr;
}

}  // namespace

void guard(Response& response) {
  Headers& headers = response.headers;
  const std::string_view type = response.content_type;
  headers.emplace_back("X-Content-Type-Options", "nosniff");
  headers.emplace_back("Referrer-Policy", "no-referrer");
  if (is_document(type)) headers.emplace_back("Content-Security-Policy", page_policy);
  if (!type.empty())  // a 304 says nothing new of what the client has
    headers.emplace_back("Cross-Origin-Resource-Policy",
                         is_shown_picture(type) ? "cross-origin" : "same-origin");
}

void share(Response& response, const Request& request, const std::vector<Origin>& origins) {
  if (origins.empty()) return;
  Headers& headers = response.headers;
  const bool any = allows_any(origins);
  const std::string_view origin = request.header("Origin");
  if (!any) add_vary(headers, "Origin");
  if (!any && std::none_of(origins.begin(), origins.end(),
                           [&](const Origin& each) { return each.text == origin; }))
    return;
  headers.emplace_back("Access-Control-Allow-Origin", any ? "*" : origin);
  headers.emplace_back("Access-Control-Expose-Headers", exposed);
  const std::string* allow = find_header(headers, "Allow");
  if (request.method != "OPTIONS" || allow == nullptr ||
      request.header("Access-Control-Request-Method").empty())
    return;
  const std::string methods = *allow;
  headers.emplace_back("Access-Control-Allow-Methods", methods);
  headers.emplace_back("Access-Control-Allow-Headers",
                       "Content-Type, If-None-Match, X-Request-Id, Tia-Delete-Key, traceparent, "
                       "Authorization");
  headers.emplace_back("Access-Control-Max-Age", preflight_seconds);
}

void add_vary(Headers& headers, std::string_view name) {
  if (std::string* vary = find_header(headers, "Vary")) vary->append(", ").append(name);
  else headers.emplace_back("Vary", name);
}

std::string joined(const Request& request, std::string_view name) {
  const std::string wanted = lower(name);
  std::string list;
  for (const auto& [key, value] : request.headers) {
    if (lower(key) != wanted) continue;
    if (!list.empty()) list += ", ";
    list += value;
  }
  return list;
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

}  // namespace tia::server
