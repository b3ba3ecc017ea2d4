#include "server/stores/aws_signature.h"

#include <algorithm>

#include "server/stores/digest.h"

namespace tia::server {
namespace {

constexpr std::string_view algorithm = "AWS4-HMAC-SHA256";

// RFC 3986, 2.3: all but what is unreserved is encoded, in capital digits.
std::string uri_encoded(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string encoded;
  for (const char c : text) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || std::string_view("-._~").find(c) < 4;
    const auto byte = static_cast<unsigned char>(c);
    if (is_plain) encoded += c;
    else (encoded += '%').append({digits[byte >> 4U], digits[byte & 15U]});
  }
  return encoded;
}

std::string trimmed(std::string_view value) {
  const auto first = value.find_first_not_of(' '), last = value.find_last_not_of(' ');
  return first == value.npos ? "" : std::string(value.substr(first, last - first + 1));
}

// Step 1: the request in canonical form; `names` are told those of its headers.
std::string canonical_request(const AwsRequest& request, std::string& names) {
  auto headers = request.headers;
  std::ranges::sort(headers);
  std::string text = request.method + '\n' + request.path + '\n' + aws_query(request.query) + '\n';
  for (const auto& [name, value] : headers) {
    text += name + ':' + trimmed(value) + '\n';
    names += (names.empty() ? "" : ";") + name;
  }
  return text + '\n' + names + '\n' + request.body_sha256;
}

}  // namespace

std::string aws_query(std::vector<std::pair<std::string, std::string>> query) {
  for (auto& [name, value] : query) name = uri_encoded(name), value = uri_encoded(value);
  std::ranges::sort(query);
  std::string text;
  for (const auto& [name, value] : query) {
    if (!text.empty()) text += '&';
    text += name + '=' + value;
  }
  return text;
}

std::string aws_authorization(const AwsRequest& request, const AwsScope& scope) {
  std::string names;
  const std::string canonical = canonical_request(request, names);
  // Step 2: what is signed.
  const std::string day = scope.time.substr(0, 8);
  const std::string of = day + '/' + scope.region + '/' + scope.service + "/aws4_request";
  const std::string text =
      std::string(algorithm) + '\n' + scope.time + '\n' + of + '\n' + sha256_hex(canonical);
  // Step 3: the key of the day, region and service, and the signature.
  std::string key = "AWS4" + scope.key_secret;
  for (const std::string& word : {day, scope.region, scope.service, std::string("aws4_request")}) {
    const Digest next = hmac_sha256(key, word);
    key.assign(next.begin(), next.end());
  }
  return std::string(algorithm) + " Credential=" + scope.key_id + '/' + of +
         ",SignedHeaders=" + names + ",Signature=" + hex(hmac_sha256(key, text));
}

}  // namespace tia::server
