// Blobs in S3, or in what speaks like it, by paths (https://host/bucket/name). A PUT is there whole
// or not at all; S3 holds its bytes against their SHA-256, which the signature names.
#include <array>
#include <chrono>
#include <ctime>
#include <stdexcept>
#include <thread>

#include "server/contract/problem.h"
#include "server/http/client.h"
#include "server/stores/aws_signature.h"
#include "server/stores/blobs.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

using Query = std::vector<std::pair<std::string, std::string>>;

constexpr int s3_tries = 4;
constexpr std::chrono::milliseconds first_pause{100};  // then twice as long each time
constexpr std::chrono::seconds s3_patience{20};

std::string time_of_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  std::array<char, 20> text{};
  const std::size_t size =
      std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", gmtime_r(&now, &parts));
  return {text.data(), size};
}

// What stands between such tags, one after the other. Names have nothing that XML escapes.
std::vector<std::string> elements(std::string_view xml, const std::string& tag) {
  const std::string open = '<' + tag + '>', close = "</" + tag + '>';
  std::vector<std::string> found;
  for (auto at = xml.find(open); at != xml.npos; at = xml.find(open, at)) {
    at += open.size();
    found.emplace_back(xml.substr(at, xml.find(close, at) - at));
  }
  return found;
}

class S3Blobs : public Blobs {
 public:
  S3Blobs(const std::string& bucket, const std::string& prefix, const S3Options& options)
      : options_(options),
        endpoint_(options.endpoint.empty() ? "https://s3." + options.region + ".amazonaws.com"
                                           : options.endpoint),
        client_(endpoint_, s3_patience),
        bucket_('/' + bucket),
        prefix_(prefix.empty() ? "" : prefix + '/') {}

  void put(const std::string& name, std::string_view bytes) override {
    const Response answer = ask("PUT", path_of(name), {}, std::string(bytes));
    if (answer.status != 200) refuse(answer);
  }
  std::optional<std::string> find(const std::string& name) override {
    Response answer = ask("GET", path_of(name), {}, "");
    if (answer.status == 404) return std::nullopt;
    if (answer.status != 200) refuse(answer);
    return std::move(answer.body);
  }
  void remove(const std::string& name) override {
    const Response answer = ask("DELETE", path_of(name), {}, "");
    if (answer.status != 204 && answer.status != 200 && answer.status != 404) refuse(answer);
  }
  // Page by page, each after the last name of the one before.
  std::vector<std::string> names(const std::string& prefix) override {
    std::vector<std::string> found;
    for (;;) {
      Query query{{"list-type", "2"}, {"prefix", prefix_ + prefix}};
      if (!found.empty()) query.emplace_back("start-after", prefix_ + found.back());
      const Response answer = ask("GET", bucket_, query, "");
      if (answer.status != 200) refuse(answer);
      const auto keys = elements(answer.body, "Key");
      for (const std::string& key : keys) found.push_back(key.substr(prefix_.size()));
      if (keys.empty() || answer.body.find("<IsTruncated>true") == answer.body.npos) return found;
    }
  }

 private:
  std::string path_of(const std::string& name) const { return bucket_ + '/' + prefix_ + name; }

  [[noreturn]] static void refuse(const Response& answer) {
    const auto codes = elements(answer.body, "Code");
    throw StorageError("S3 (option TIA_STORE) answers " + std::to_string(answer.status) +
                       (codes.empty() ? "" : ", " + codes.front()));
  }

  // What it cannot do now it may do soon.
  Response ask(const std::string& method, const std::string& path, const Query& query,
               const std::string& body) {
    auto pause = first_pause;
    for (int i = 1;; ++i, pause *= 2) {
      std::string why;
      try {
        Response answer = ask_once(method, path, query, body);
        if (answer.status == 507) throw store_full();
        if (answer.status < 500 && answer.status != 429) return answer;
        why = "answers " + std::to_string(answer.status);
      } catch (const HttpError&) {
        throw;
      } catch (const std::runtime_error& error) {
        why = error.what();
      }
      if (i == s3_tries) throw StorageAway("S3 (option TIA_STORE): " + why);
      std::this_thread::sleep_for(pause);
    }
  }

  Response ask_once(const std::string& method, const std::string& path, const Query& query,
                    const std::string& body) {
    AwsRequest request{.method = method, .path = path, .query = query};
    request.body_sha256 = sha256_hex(body);
    const std::string time = time_of_now();
    request.headers = {{"host", endpoint_.substr(endpoint_.find("://") + 3)},
                       {"x-amz-content-sha256", request.body_sha256},
                       {"x-amz-date", time}};
    Headers sent = request.headers;
    sent.emplace_back("Content-Type", "application/octet-stream");
    if (method == "DELETE") sent.emplace_back("Content-Length", "0");
    sent.emplace_back("Authorization",
                      aws_authorization(request, {options_.key_id, options_.key_secret, time,
                                                  options_.region, "s3"}));
    return client_.ask(method, query.empty() ? path : path + '?' + aws_query(query), body, sent);
  }

  const S3Options options_;
  const std::string endpoint_;
  const Client client_;
  const std::string bucket_, prefix_;
};

}  // namespace

std::unique_ptr<Blobs> blobs_in_s3(const std::string& bucket, const std::string& prefix,
                                   const S3Options& options) {
  return std::make_unique<S3Blobs>(bucket, prefix, options);
}

}  // namespace tia::server
