#include "server/jobs/farm.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "core/version.h"
#include "server/access/shared_quotas.h"

namespace tia::server {
namespace {

std::string farm_file(const char* option, const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw std::invalid_argument(std::string("option ") + option + ": cannot read " + name);
  return text;
}

// Without the end of its line.
std::string farm_password(const Config& config) {
  if (config.farm_password_file.empty()) return "";
  std::string text = farm_file("TIA_FARM_PASSWORD_FILE", config.farm_password_file);
  if (text.ends_with('\n')) text.pop_back();
  if (text.empty()) throw std::invalid_argument("option TIA_FARM_PASSWORD_FILE: the file is empty");
  return text;
}

bool is_worker_name(const std::string& name) {
  return !name.empty() && name.size() <= longest_worker_name &&
         std::all_of(name.begin(), name.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '.' || c == '-' || c == '_';
         });
}

RedisAddress farm_address(const std::string& url) {
  try {
    return read_redis_url(url);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("option TIA_FARM: got " + url + ", needed: " + error.what());
  }
}

// An endpoint is a URL without a path: what is signed is the host as it is sent.
bool is_endpoint(std::string_view url) {
  const bool is_http = url.starts_with("http://") || url.starts_with("https://");
  const std::string_view host = url.substr(std::min(url.size(), url.find("//") + 2));
  return is_http && !host.empty() && host.find_first_of("/?#@ ") == host.npos;
}

S3Options s3_options(const Config& config) {
  if (!config.s3_endpoint.empty() && !is_endpoint(config.s3_endpoint))
    throw std::invalid_argument("option TIA_S3_ENDPOINT: got " + config.s3_endpoint +
                                ", allowed: https://HOST[:PORT], or http://");
  S3Options options{.endpoint = config.s3_endpoint, .region = config.s3_region};
  if (config.s3_key_file.empty()) return options;
  std::istringstream lines(farm_file("TIA_S3_KEY_FILE", config.s3_key_file));
  if (!(lines >> options.key_id >> options.key_secret))
    throw std::invalid_argument(
        "option TIA_S3_KEY_FILE: needed: two lines, a key's id and its secret");
  return options;
}

RedisOptions farm_redis(const Config& config) {
  if (!config.farm_ca_file.empty())
    static_cast<void>(farm_file("TIA_FARM_CA_FILE", config.farm_ca_file));
  return {.at = farm_address(config.farm),
          .password = farm_password(config),
          .ca_file = config.farm_ca_file};
}

}  // namespace

std::shared_ptr<Blobs> result_store(const Config& config) {
  if (config.store.empty()) return nullptr;
  const S3Options s3 = s3_options(config);
  try {
    return blobs_at(config.store, s3);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string("option TIA_STORE: ") + error.what());
  }
}

std::unique_ptr<Quotas> quotas_of(const Config& config) {
  if (config.farm.empty()) return std::make_unique<OwnQuotas>();
  return std::make_unique<SharedQuotas>(farm_redis(config));
}

std::string own_worker_name() {
  std::array<char, longest_worker_name + 1> host{};
  if (::gethostname(host.data(), host.size() - 1) != 0) host.front() = '\0';
  std::string name(host.data());
  std::erase_if(name, [](char c) { return !is_worker_name(std::string(1, c)); });
  const std::string end = '-' + std::to_string(::getpid());
  return name.substr(0, longest_worker_name - end.size()) + end;
}

std::unique_ptr<RedisJobs> farm_jobs(const Config& config, const JobLimits& limits, FarmRole role,
                                     const std::string& name) {
  if (!is_worker_name(name))
    throw std::invalid_argument("--name: got " + name + ", allowed: 1 to " +
                                std::to_string(longest_worker_name) +
                                " letters, digits, '.', '-', '_'");
  return std::make_unique<RedisJobs>(FarmOptions{.redis = farm_redis(config),
                                                 .limits = limits,
                                                 .version = full_version(),
                                                 .name = name,
                                                 .role = role,
                                                 .lease_ms = config.farm_lease_ms,
                                                 .audit = config.farm_audit,
                                                 .store = result_store(config)});
}

}  // namespace tia::server
