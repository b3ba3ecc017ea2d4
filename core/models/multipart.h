// Forms of several parts, multipart/form-data, as browsers and curl send files.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/models/model_files.h"

namespace tia {

/// FormPart: a field of a form, or a file in it.
struct FormPart {
  std::string name;
  std::optional<std::string> filename;  ///< as it came, not a clean path
  std::string content_type;             ///< as it came; "" where none
  ModelBytes bytes;                     ///< a view into the body
};

/// The boundary that the type multipart/form-data of a body names: 1 to 70 of RFC 2046's
/// characters, between quotation marks or not. Returns: nothing for another type, without a
/// boundary, with two or with another.
/// Source: RFC 2046, section 5.1.1; RFC 9110, section 5.6.6.
std::optional<std::string> boundary_of(std::string_view content_type);

/// The parts of a body, in their order; none where there is a fault. What stands before the first
/// boundary and after the last is passed over. Names have %22, %0D, %0A, \" and \\ undone, which
/// stand for ", CR, LF, " and \; parameters with a * are passed over.
/// Domain: a boundary as boundary_of() gives it.
/// Errors: faults whose words say which part, from 1: `malformed`; `limit` of parts, 1024, and of a
/// part's headers, 16 KiB.
/// Cost: linear in the body. Source: RFC 7578; RFC 2046, section 5.1.1; WHATWG HTML, "multipart
/// form data", for the names.
std::vector<FormPart> parse_multipart(ModelBytes body, std::string_view boundary, Faults& faults);

}  // namespace tia
