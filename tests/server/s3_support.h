// What speaks like S3, in the test's own process: it holds each request against its signature, and
// fails as it is told to.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "server/stores/blobs.h"

namespace tia::test {

/// S3StandIn: one bucket, "tia-test", on a free port of the loopback.
class S3StandIn {
 public:
  /// What becomes of the next requests of that method.
  enum class Fault { answers_500, flips_a_bit, cuts_the_body, is_full };

  S3StandIn();
  ~S3StandIn();
  S3StandIn(const S3StandIn&) = delete;
  S3StandIn& operator=(const S3StandIn&) = delete;

  server::S3Options options() const;
  std::string endpoint() const;
  /// The file of TIA_S3_KEY_FILE, in its words.
  std::string key_file() const;
  void fail(const std::string& method, Fault fault, int times);
  std::map<std::string, std::string> kept() const;
  /// Puts something else in its place.
  void damage(const std::string& name);
  int refused() const { return refused_; }

 private:
  struct Listener;
  bool is_signed(const std::string& method, const std::string& target,
                 const std::map<std::string, std::string>& headers, const std::string& body);

  mutable std::mutex mutex_;
  std::map<std::string, std::string> kept_;
  std::map<std::string, std::pair<Fault, int>> faults_;
  int refused_ = 0, port_ = 0;
  std::unique_ptr<Listener> listener_;
  std::jthread thread_;
};

}  // namespace tia::test
