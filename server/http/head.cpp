#include "server/http/head.h"

#include <algorithm>
#include <charconv>

#include "server/http/error.h"

namespace tia::server {
namespace {

[[noreturn]] void malformed(const std::string& detail) { throw HttpError("malformed", detail); }

bool is_token(std::string_view text) {  // RFC 9110, 5.6.2
  constexpr std::string_view marks = "!#$%&'*+-.^_`|~";
  return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           marks.find(c) != marks.npos;
  });
}

bool is_visible(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < '\x7f'; });
}

// Takes the next line and its end off the text.
std::string_view take_line(std::string_view& text) {
  const auto end = text.find("\r\n");
  if (end == text.npos) malformed("a line of the head does not end with CR LF");
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 2);
  return line;
}

// A name or an address, and a port (RFC 9112, 3.2).
bool is_host(std::string_view host) {
  constexpr std::string_view never = "/?#@\\<>\"{}|^`, ";
  if (!is_visible(host) || host.find_first_of(never) != host.npos) return false;
  const auto bracket = host.find(']');
  if ((host.substr(0, 1) == "[") != (bracket != host.npos)) return false;
  const std::string_view after = bracket == host.npos ? host : host.substr(bracket + 1);
  const auto colon = after.find(':');
  if (bracket != host.npos && !after.empty() && colon != 0) return false;
  return colon == after.npos ||
         after.substr(colon + 1).find_first_not_of("0123456789") == after.npos;
}

/// Target: what a request line asks for.
struct Target {
  std::string path, host;  // "": Host says which
};

// http://host/path is what proxies are sent, and then its host counts (RFC 9112, 3.2.2).
Target target_of(std::string_view target, std::string_view method) {
  if (target == "*" && method == "OPTIONS") return {"*", ""};
  for (const std::string_view scheme : {"http://", "https://"})
    if (same_word(target.substr(0, scheme.size()), scheme)) {
      const auto path = target.find_first_of("/?", scheme.size());
      const std::string_view host = target.substr(0, path).substr(scheme.size());
      if (host.empty() || !is_host(host)) malformed("the target names no host");
      std::string rest(path == target.npos ? "" : target.substr(path));
      if (rest.empty() || rest[0] != '/') rest.insert(rest.begin(), '/');
      return {rest, std::string(host)};
    }
  if (target.empty() || target[0] != '/') malformed("the target must begin with /");
  return {std::string(target), ""};
}

/// RequestLine: METHOD target HTTP/1.x.
struct RequestLine {
  std::string method;
  Target target;
  bool is_http_1_1;
};

RequestLine read_request_line(std::string_view line) {
  const auto first = line.find(' '), last = line.rfind(' ');
  if (first == line.npos || first == last)
    malformed("the first line must be METHOD TARGET HTTP/1.1");
  const std::string_view method = line.substr(0, first), version = line.substr(last + 1);
  const std::string_view target = line.substr(first + 1, last - first - 1);
  if (!is_token(method)) malformed("the method is no word");
  if (!is_visible(target)) malformed("the target holds white space or characters beyond ASCII");
  const bool is_http = version.size() == 8 && version.substr(0, 5) == "HTTP/";
  if (!is_http) malformed("the first line must end with HTTP/1.1");
  if (version != "HTTP/1.1" && version != "HTTP/1.0")
    throw HttpError("version", "this server speaks HTTP/1.1 and HTTP/1.0");
  return {std::string(method), target_of(target, method), version == "HTTP/1.1"};
}

// The value of a field that may come once, or "".
std::string_view only(const Headers& headers, std::string_view name) {
  const std::string* found = nullptr;
  for (const auto& [key, value] : headers) {
    if (!same_word(key, name)) continue;
    if (found != nullptr) malformed(std::string(name) + " comes twice");
    found = &value;
  }
  return found == nullptr ? std::string_view() : *found;
}

bool has(const Headers& headers, std::string_view name) {
  return std::any_of(headers.begin(), headers.end(),
                     [&](const auto& field) { return same_word(field.first, name); });
}

// Whether one of the words of all fields of that name, parted by commas, is the word.
bool lists(const Headers& headers, std::string_view name, std::string_view word) {
  for (const auto& [key, value] : headers) {
    if (!same_word(key, name)) continue;
    std::string_view rest = value;
    for (;;) {
      const auto comma = rest.find(',');
      if (same_word(trimmed(rest.substr(0, comma)), word)) return true;
      if (comma == rest.npos) break;
      rest.remove_prefix(comma + 1);
    }
  }
  return false;
}

std::int64_t length_of(std::string_view text) {
  std::int64_t length = 0;
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  const auto end = text.data() + text.size();
  if (!digits || std::from_chars(text.data(), end, length).ec != std::errc())
    malformed("Content-Length must be one number of bytes");
  return length;
}

// How the body comes (RFC 9112, 6.3), where only one reading is possible.
void read_framing(Head& head, bool is_11) {
  const std::string_view coding = only(head.headers, "Transfer-Encoding");
  if (has(head.headers, "Transfer-Encoding")) {
    if (has(head.headers, "Content-Length"))
      malformed("Transfer-Encoding and Content-Length exclude each other");
    if (!is_11) malformed("Transfer-Encoding is not for HTTP/1.0");
    if (!same_word(coding, "chunked"))
      throw HttpError("not-implemented", "the only transfer coding that is read is chunked");
    head.body = Head::Body::chunked;
  } else if (has(head.headers, "Content-Length")) {
    head.body = Head::Body::sized;
    head.length = length_of(only(head.headers, "Content-Length"));
  }
}

bool is_bodiless(std::string_view method) {
  return method == "GET" || method == "HEAD" || method == "OPTIONS" || method == "TRACE" ||
         method == "CONNECT" || method == "DELETE";
}

// Whether the method means to bring a body, however the client tells its length. A method that is
// not known brings none unless it says so (RFC 9112, 6.3).
bool brings_body(std::string_view method) {
  return method == "POST" || method == "PUT" || method == "PATCH";
}

void check_body(const Head& head) {
  const bool announced = head.body == Head::Body::chunked || head.length > 0;
  if (is_bodiless(head.method) && announced)
    malformed(head.method + " takes no body; send one with POST");
  if (brings_body(head.method) && head.body == Head::Body::none)
    throw HttpError("length-required",
                    "a body needs Content-Length, or to be chunked; of no body "
                    "say Content-Length: 0");
  const std::string_view coding = only(head.headers, "Content-Encoding");
  if (!coding.empty() && !same_word(coding, "identity"))
    throw HttpError("media-type", "a body must come as it is, not compressed",
                    {{"Accept-Encoding", "identity"}});
}

void check_host(const Headers& headers, bool is_11) {
  if (is_11 && !has(headers, "Host")) malformed("HTTP/1.1 asks for a Host field");
  const std::string_view host = only(headers, "Host");
  if (!is_host(host)) malformed("Host must be a name or an address, and a port");
}

void set_host(Headers& headers, const std::string& host) {
  std::erase_if(headers, [](const auto& field) { return same_word(field.first, "Host"); });
  headers.emplace_back("Host", host);
}

}  // namespace

Headers read_fields(std::string_view text) {
  Headers headers;
  for (std::string_view line = take_line(text); !line.empty(); line = take_line(text)) {
    const auto colon = line.find(':');
    const std::string_view name = line.substr(0, colon);
    if (colon == line.npos || !is_token(name))
      malformed("a header field must be NAME: VALUE, on one line, without space before the colon");
    if (headers.size() == Head::most_fields)
      throw HttpError("header-too-large",
                      "a head may have " + std::to_string(Head::most_fields) + " fields");
    headers.emplace_back(name, trimmed(line.substr(colon + 1)));
  }
  return headers;
}

Head read_head(std::string_view text) {
  const RequestLine line = read_request_line(take_line(text));
  const bool is_11 = line.is_http_1_1;
  Head head{.method = line.method, .target = line.target.path, .headers = read_fields(text)};
  check_host(head.headers, is_11);
  if (!line.target.host.empty()) set_host(head.headers, line.target.host);
  read_framing(head, is_11);
  check_body(head);
  head.is_http_1_0 = !is_11;
  head.keep_alive = is_11 && !lists(head.headers, "Connection", "close");
  const std::string_view expectation = only(head.headers, "Expect");
  head.expects_continue = is_11 && same_word(expectation, "100-continue");
  if (!expectation.empty() && !same_word(expectation, "100-continue"))
    throw HttpError("expectation", "the only expectation that is met is 100-continue");
  return head;
}

void check_length(std::uint64_t size, const BodyLimit& limit) {
  if (size > static_cast<std::uint64_t>(limit.most_bytes))
    throw HttpError("too-large", "a body of its type may have " + std::to_string(limit.most_bytes) +
                                     " bytes (option " + limit.option + ")");
}

void check_lines(std::string_view text, std::size_t from) {
  for (std::size_t i = from; i < text.size(); ++i) {
    const char c = text[i];
    const bool lone_lf = c == '\n' && (i == 0 || text[i - 1] != '\r');
    const bool lone_cr = c == '\r' && i + 1 < text.size() && text[i + 1] != '\n';
    const bool control = (c >= 0 && c < ' ' && c != '\t' && c != '\r' && c != '\n') || c == '\x7f';
    if (lone_lf || lone_cr || control)
      malformed("the head holds a control character, or a line end that is not CR LF");
  }
}

}  // namespace tia::server
