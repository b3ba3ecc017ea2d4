// The parts that the corpus of requests is made of.
#pragma once

#include <cstddef>
#include <string>

namespace tia::test::forms {

using Text = std::string;

Text get(const Text& fields);
Text line(const Text& first, const Text& fields = "Host: x\r\n");
Text post(const Text& fields, const Text& body = "");
Text sized(const Text& length, const Text& body = "{}");
Text coded(const Text& coding, const Text& body = "2\r\n{}\r\n0\r\n\r\n");
Text chunks(const Text& body);
Text host(const Text& host);
Text zeros(std::size_t count);
Text fields(std::size_t count);

}  // namespace tia::test::forms
