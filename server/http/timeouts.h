// How long a connection may take for what, and how much it may hold.
#pragma once

#include <chrono>
#include <cstddef>

namespace tia::server::timeouts {

using std::chrono::seconds;

constexpr seconds head{5};    ///< from connecting, or a request's first byte, to its head's end
constexpr seconds body{5};    ///< for a body, besides what it may take at slowest_rate
constexpr seconds answer{8};  ///< as body, for taking an answer
constexpr seconds look{1};    ///< between two looks at how much of an answer has been taken
constexpr seconds idle{30};   ///< between two requests
constexpr seconds linger{2};  ///< for reading an answer after which we close
constexpr seconds stuck{1};   ///< without taking a byte of an answer, where others need the place
constexpr seconds rest{1};    ///< without work, before memory is given back
constexpr std::chrono::milliseconds drained{250};  ///< for a first request once we go down
constexpr std::chrono::milliseconds memory{1};     ///< before it is asked for again

constexpr std::size_t slowest_rate = 64 << 10;   ///< bytes a second that a client must keep up
constexpr std::size_t most_requests = 100'000;   ///< of one connection
constexpr std::size_t most_ahead = 64 << 10;     ///< bytes sent before an answer has come
constexpr std::size_t most_at_once = 256 << 10;  ///< bytes sent in one go
constexpr std::size_t most_parts = 256 << 10;    ///< bytes of an answer's parts that wait

/// How long so many bytes may take.
constexpr std::chrono::milliseconds at_slowest_rate(std::size_t bytes) {
  return std::chrono::milliseconds(bytes * 1000 / slowest_rate);
}

}  // namespace tia::server::timeouts
