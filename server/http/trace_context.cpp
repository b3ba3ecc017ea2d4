#include "server/http/trace_context.h"

#include <algorithm>
#include <cstdint>
#include <random>

namespace tia::server {
namespace {

constexpr std::string_view digits = "0123456789abcdef";
constexpr std::size_t known_size = 55;  // of version 00: 00-<32>-<16>-<2>
constexpr std::size_t known_flags = 3;  // sampled, and the trace's id is random

bool is_hexadecimal(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return digits.find(c) != digits.npos; });
}

bool is_zero(std::string_view id) { return id.find_first_not_of('0') == id.npos; }

}  // namespace

std::string TraceContext::traceparent() const {
  return "00-" + trace_id + '-' + span_id + '-' + flags;
}

std::optional<TraceContext> trace_context(std::string_view field) {
  if (field.size() < known_size || field[2] != '-' || field[35] != '-' || field[52] != '-')
    return std::nullopt;
  const std::string_view version = field.substr(0, 2), trace = field.substr(3, 32),
                         parent = field.substr(36, 16), flags = field.substr(53, 2);
  for (const std::string_view part : {version, trace, parent, flags})
    if (!is_hexadecimal(part)) return std::nullopt;
  if (version == "ff" || is_zero(trace) || is_zero(parent)) return std::nullopt;
  if (field.size() > known_size && (version == "00" || field[known_size] != '-'))
    return std::nullopt;
  return TraceContext{std::string(trace),
                      std::string(parent),
                      random_digits(16),
                      {'0', digits[digits.find(flags[1]) & known_flags]}};
}

std::string random_digits(std::size_t count) {
  thread_local std::mt19937_64 random{std::random_device{}()};
  std::string text(count, '0');
  std::uint64_t word = 0;
  for (std::size_t i = 0; i < count; ++i) {
    word = i % 16 == 0 ? random() : word >> 4U;
    text[i] = digits[word & 15U];
  }
  return text;
}

}  // namespace tia::server
