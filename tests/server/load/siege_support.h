// What a siege is made of: requests that are as dear as may be for their size, each legal or not.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/socket_support.h"

namespace tia::test {

/// Asker: a client that asks one thing after the other, each on a connection of its own, from an
/// address that it says it forwards for.
class Asker {
 public:
  Asker(int port, std::string address) : port_(port), address_(std::move(address)) {}

  /// Sends the request and reads its answer whole, or leaves when the time is up.
  /// Returns: the status; 0 where it left, or the server closed first.
  int ask(const std::string& method, const std::string& target, const std::string& body = "",
          Clock::duration timeout = seconds(30), const char* type = "application/json");
  /// The body of the last answer.
  const std::string& body() const { return body_; }

 private:
  int port_;
  std::string address_, body_;
};

/// Neighbour: an ordinary client. It drags a light, and looks whether the server is well.
class Neighbour {
 public:
  Neighbour(int port, const char* address) : asker_(port, address) {}

  /// None of them seen before; it asks for the next one as a page does: once the last has come and
  /// a frame is over.
  double pictures_a_second(Clock::duration time);
  /// The 95th percentile of asking for /healthz. Unit: ms.
  double health_ms(Clock::duration time);

 private:
  Asker asker_;
  int last_ = 0;
};

/// Attack: what one kind of attacker does, again and again; `turn` counts from 0.
struct Attack {
  const char* law;
  std::function<void(Asker& asker, int turn)> act;
};
/// All kinds, their payloads made.
std::vector<Attack> attacks();

/// Siege: an attacker of each kind at work, all at once, while it lives.
class Siege {
 public:
  Siege(int port, std::vector<Attack> attacks);
  ~Siege();
  /// How often each kind has acted.
  std::vector<int> turns() const;

 private:
  std::vector<Attack> attacks_;
  std::vector<std::atomic<int>> turns_;
  std::atomic<bool> over_ = false;
  std::vector<std::jthread> attackers_;
};

}  // namespace tia::test
