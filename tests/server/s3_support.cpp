#include "tests/server/s3_support.h"

#include <httplib.h>

#include "server/stores/aws_signature.h"
#include "server/stores/digest.h"

namespace tia::test {
namespace {

constexpr const char* bucket_path = "/tia-test";
constexpr std::size_t page = 2;  // so that lists have several
const server::AwsScope known_scope{"the-id", "the-secret", "", "eu-test-1", "s3"};

// The plain text of a percent-encoded one.
std::string decoded(const std::string& text) { return httplib::detail::decode_url(text, false); }

}  // namespace

struct S3StandIn::Listener {
  httplib::Server server;
};

S3StandIn::S3StandIn() : listener_(std::make_unique<Listener>()) {
  httplib::Server& server = listener_->server;
  const auto answer = [this](const httplib::Request& request, httplib::Response& response) {
    const std::map<std::string, std::string> headers(request.headers.begin(),
                                                     request.headers.end());
    const std::lock_guard lock(mutex_);
    if (!is_signed(request.method, request.target, headers, request.body)) {
      ++refused_;
      response.status = 403;
      response.set_content("<Error><Code>SignatureDoesNotMatch</Code></Error>", "application/xml");
      return;
    }
    auto& [fault, left] = faults_[request.method];
    const bool fails = left > 0 && left-- > 0;
    if (fails && fault == Fault::answers_500) return void(response.status = 500);
    if (fails && fault == Fault::is_full) return void(response.status = 507);
    const std::string name = request.path.substr(std::string(bucket_path).size() + 1 -
                                                 (request.path == bucket_path ? 1 : 0));
    if (request.method == "PUT") {
      kept_[name] = request.body;
      return;
    }
    if (request.method == "DELETE") {
      kept_.erase(name);
      response.status = 204;
      return;
    }
    if (name.empty()) {
      std::string xml = "<ListBucketResult>";
      std::size_t count = 0;
      for (const auto& [key, bytes] : kept_) {
        if (!key.starts_with(request.get_param_value("prefix"))) continue;
        if (key <= request.get_param_value("start-after")) continue;
        if (count++ == page) {
          xml += "<IsTruncated>true</IsTruncated>";
          break;
        }
        xml += "<Contents><Key>" + key + "</Key></Contents>";
      }
      return response.set_content(xml + "</ListBucketResult>", "application/xml");
    }
    const auto found = kept_.find(name);
    if (found == kept_.end()) return void(response.status = 404);
    std::string bytes = found->second;
    if (fails && fault == Fault::flips_a_bit) bytes[bytes.size() / 2] ^= 1;
    if (!fails || fault != Fault::cuts_the_body)
      return response.set_content(bytes, "application/octet-stream");
    response.set_content_provider(
        bytes.size() + 1, "application/octet-stream",
        [bytes](std::size_t offset, std::size_t, httplib::DataSink& sink) {
          return offset == 0 && sink.write(bytes.data(), bytes.size());
        });
  };
  server.Get(".*", answer);
  server.Put(".*", answer);
  server.Delete(".*", answer);
  port_ = server.bind_to_any_port("127.0.0.1");
  thread_ = std::jthread([&server] { server.listen_after_bind(); });
}

S3StandIn::~S3StandIn() {
  while (!listener_->server.is_running()) std::this_thread::yield();
  listener_->server.stop();
}

// By the words of AWS' description: whoever signs otherwise is refused.
bool S3StandIn::is_signed(const std::string& method, const std::string& target,
                          const std::map<std::string, std::string>& headers,
                          const std::string& body) {
  const auto header = [&](const char* name) {
    const auto found = headers.find(name);
    return found == headers.end() ? "" : found->second;
  };
  server::AwsScope scope = known_scope;
  scope.time = header("x-amz-date");
  server::AwsRequest request{.method = method};
  request.path = target.substr(0, target.find('?'));
  std::string query = target.substr(std::min(target.size(), request.path.size() + 1));
  while (!query.empty()) {
    const std::string one = query.substr(0, query.find('&'));
    query.erase(0, one.size() + 1);
    request.query.emplace_back(decoded(one.substr(0, one.find('='))),
                               decoded(one.substr(one.find('=') + 1)));
  }
  request.body_sha256 = server::sha256_hex(body);
  request.headers = {{"host", "127.0.0.1:" + std::to_string(port_)},
                     {"x-amz-content-sha256", request.body_sha256},
                     {"x-amz-date", scope.time}};
  return header("Authorization") == aws_authorization(request, scope);
}

server::S3Options S3StandIn::options() const {
  return {.endpoint = endpoint(),
          .region = known_scope.region,
          .key_id = known_scope.key_id,
          .key_secret = known_scope.key_secret};
}
std::string S3StandIn::endpoint() const { return "http://127.0.0.1:" + std::to_string(port_); }
std::string S3StandIn::key_file() const {
  return known_scope.key_id + '\n' + known_scope.key_secret + '\n';
}

void S3StandIn::fail(const std::string& method, Fault fault, int times) {
  const std::lock_guard lock(mutex_);
  faults_[method] = {fault, times};
}
std::map<std::string, std::string> S3StandIn::kept() const {
  const std::lock_guard lock(mutex_);
  return kept_;
}
void S3StandIn::damage(const std::string& name) {
  const std::lock_guard lock(mutex_);
  kept_.at(name) += 'x';
}

}  // namespace tia::test
