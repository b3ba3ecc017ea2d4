// The short way from a form's body to its parts, or to why it has none.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "core/models/multipart.h"
#include "tests/core/faults.h"
#include "tests/core/models/file_bytes.h"

namespace tia::test {

// A part as a test expects it.
struct ExpectedPart {
  std::string name;
  std::optional<std::string> filename;
  std::string type, bytes;
  bool operator==(const ExpectedPart&) const = default;
};
inline void PrintTo(const ExpectedPart& part,
                    std::ostream* out) {  // NOLINT(readability-identifier-naming)
  *out << part.name << ", " << part.filename.value_or("no file") << ", " << part.type << ", "
       << part.bytes;
}
using FormParts = std::vector<ExpectedPart>;

inline FormParts parts_of_form(const std::string& body, std::string_view boundary, Faults& faults) {
  const std::vector<std::uint8_t> bytes(body.begin(), body.end());  // ends where its memory does
  FormParts parts;
  for (const FormPart& part : parse_multipart(bytes, boundary, faults))
    parts.push_back(
        {part.name, part.filename, part.content_type, std::string(text_of_file(part.bytes))});
  return parts;
}
inline FormParts parts_of_form(const std::string& body, std::string_view boundary = "b") {
  Faults faults;
  FormParts parts = parts_of_form(body, boundary, faults);
  faults.raise();
  return parts;
}
inline void expect_form_refused(const std::string& body, const std::vector<Expected>& expected) {
  SCOPED_TRACE(body.substr(0, 200));
  Faults faults;
  EXPECT_EQ(parts_of_form(body, "b", faults), FormParts());
  expect_faults(faults.list(), expected);
}
inline Expected wrong_in_part(const std::string& part, const std::string& allowed) {
  return {FaultKind::malformed, "", "\"part " + part + "\"", allowed};
}
inline std::string form_with(const std::string& headers, const std::string& bytes = "x") {
  return "--b\r\n" + headers + "\r\n\r\n" + bytes + "\r\n--b--\r\n";
}

}  // namespace tia::test
