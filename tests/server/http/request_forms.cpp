#include "tests/server/http/request_forms.h"

namespace tia::test::forms {

Text get(const Text& fields) { return "GET /healthz HTTP/1.1\r\nHost: x\r\n" + fields + "\r\n"; }
Text line(const Text& first, const Text& fields) { return first + "\r\n" + fields + "\r\n"; }
Text post(const Text& fields, const Text& body) {
  return "POST /render HTTP/1.1\r\nHost: x\r\n" + fields + "\r\n" + body;
}
Text sized(const Text& length, const Text& body) {
  return post("Content-Length:" + length + "\r\n", body);
}
Text coded(const Text& coding, const Text& body) {
  return post("Transfer-Encoding:" + coding + "\r\n", body);
}
Text chunks(const Text& body) { return coded(" chunked", body); }
Text host(const Text& host) { return line("GET /healthz HTTP/1.1", "Host:" + host + "\r\n"); }
Text zeros(std::size_t count) { return Text(count, '\0'); }
Text fields(std::size_t count) {
  Text all;
  for (std::size_t i = 0; i < count; ++i) all += "a:b\r\n";
  return all;
}

}  // namespace tia::test::forms
