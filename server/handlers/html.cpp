#include "server/handlers/html.h"

namespace tia::server {

std::string escaped(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&') html += "&amp;";
    else if (c == '<') html += "&lt;";
    else if (c == '>') html += "&gt;";
    else if (c == '"') html += "&quot;";
    else html += c;
  }
  return html;
}

std::string element(std::string_view tag, std::string_view html, std::string_view attributes) {
  std::string all("<");
  all.append(tag);
  if (!attributes.empty()) all.append(" ").append(attributes);
  return all.append(">").append(html).append("</").append(tag).append(">");
}

std::string code(std::string_view text) { return element("code", escaped(text)); }

std::string link_to(std::string_view id, std::string_view html) {
  std::string href("href=\"#");
  return element("a", html, href.append(escaped(id)).append("\""));
}

}  // namespace tia::server
