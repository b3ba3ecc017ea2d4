// How requests to AWS' services, and to those that speak like S3, are signed: Signature Version 4.
// Source: AWS, "Create a signed AWS API request" (IAM user guide).
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tia::server {

/// AwsRequest: what is signed of a request.
struct AwsRequest {
  std::string method, path = {};  ///< the path percent-encoded, as it is sent
  std::vector<std::pair<std::string, std::string>> query = {};    ///< plain names and values
  std::vector<std::pair<std::string, std::string>> headers = {};  ///< small names; Host among them
  std::string body_sha256 = {};                                   ///< 64 hexadecimal digits
};

/// AwsScope: by which key, when and for what a signature holds.
struct AwsScope {
  std::string key_id, key_secret, time;  ///< the time as 20130524T000000Z
  std::string region, service;
};

/// The query, as it is signed and sent: in the order of names, percent-encoded.
std::string aws_query(std::vector<std::pair<std::string, std::string>> query);

/// The value of the field Authorization. Errors: std::bad_alloc.
std::string aws_authorization(const AwsRequest& request, const AwsScope& scope);

}  // namespace tia::server
