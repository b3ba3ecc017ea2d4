// The parts that the corpus of requests is made of.
#pragma once

#include <string>

namespace tia::test::forms {

using Text = std::string;

inline Text get(const Text& fields) {
  return "GET /healthz HTTP/1.1\r\nHost: x\r\n" + fields + "\r\n";
}
inline Text line(const Text& first, const Text& fields = "Host: x\r\n") {
  return first + "\r\n" + fields + "\r\n";
}
inline Text post(const Text& fields, const Text& body = "") {
  return "POST /render HTTP/1.1\r\nHost: x\r\n" + fields + "\r\n" + body;
}
inline Text sized(const Text& length, const Text& body = "{}") {
  return post("Content-Length:" + length + "\r\n", body);
}
inline Text coded(const Text& coding, const Text& body = "2\r\n{}\r\n0\r\n\r\n") {
  return post("Transfer-Encoding:" + coding + "\r\n", body);
}
inline Text chunks(const Text& body) { return coded(" chunked", body); }
inline Text host(const Text& host) {
  return line("GET /healthz HTTP/1.1", "Host:" + host + "\r\n");
}
inline Text zeros(std::size_t count) { return Text(count, '\0'); }
inline Text fields(std::size_t count) {
  Text all;
  for (std::size_t i = 0; i < count; ++i) all += "a:b\r\n";
  return all;
}

}  // namespace tia::test::forms
