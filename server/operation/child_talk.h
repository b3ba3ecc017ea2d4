// ChildTalk: a program that is sent its input while what it writes is read.
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "server/operation/child.h"

namespace tia::server {

/// ChildTalk. With it the program ends: it is killed, if need be. One thread at a time.
class ChildTalk {
 public:
  using Bytes = std::span<const std::uint8_t>;

  /// Starts a program as start_child() does, which is sent these pieces one after the other.
  /// Domain: they outlive it. Errors: std::system_error where it cannot be started.
  ChildTalk(const std::string& program, const std::vector<std::string>& arguments,
            std::vector<Bytes> input, std::size_t most_output, std::stop_token stop);

  /// What it writes next. Returns: how many bytes, at least one; 0 once it writes nothing more, or
  /// has written more than it may: one byte more is given then. Domain: there is room.
  /// Errors: Stopped.
  std::size_t read(std::span<std::uint8_t> room);
  /// How many bytes may still come, with the one that is too much.
  std::size_t left() const { return left_; }
  /// Whether it writes nothing more.
  bool ended() const { return ended_; }
  /// Waits for its end, and kills it first unless it has written all. Returns: its status, as
  /// waitpid has it. Domain: once.
  int end();

 private:
  void send_more();

  StartedChild started_;
  std::vector<Bytes> input_;
  std::size_t at_ = 0, sent_ = 0;  // what is sent: pieces, and bytes of the next
  bool sending_ = true;
  std::size_t left_;
  bool ended_ = false;
  std::stop_token stop_;
};

}  // namespace tia::server
