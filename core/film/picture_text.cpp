#include "core/film/picture_text.h"

#include <string>
#include <utility>

#include "core/input/base64.h"

namespace tia {
namespace {

// The regular expression of base64: groups of four digits, the last one padded, its unused bits 0.
constexpr std::string_view file_pattern =
    "^([A-Za-z0-9+/]{4})*([A-Za-z0-9+/][AQgw]==|[A-Za-z0-9+/]{2}[AEIMQUYcgkosw048]=)?$";

void add_limit(const Place& at, std::string got, std::string allowed, Faults& faults) {
  faults.add({FaultKind::limit, at.pointer(), Value(std::move(got)), std::move(allowed)});
}

// Whether the input may still have so many pixels. If not, adds a fault.
bool take(Bulk bulk, std::int64_t pixels, std::string_view counted, const Place& at,
          Faults& faults) {
  if (faults.take(bulk, pixels)) return true;
  add_limit(at, std::to_string(pixels) + " pixels more",
            "pictures of at most " + std::to_string(most_of(bulk)) + " pixels together" +
                std::string(counted),
            faults);
  return false;
}

}  // namespace

std::optional<FileBytes> read_file(const Value& v, std::string_view words, std::size_t most_bytes,
                                   const Place& at, Faults& faults) {
  const auto* text = v.as<std::string>();
  FileBytes bytes;
  if (text == nullptr) {
    detail::wrong_type(v, at, std::string(words), faults);
  } else if (text->size() > (most_bytes + 2) / 3 * 4) {
    add_limit(at, std::to_string(text->size()) + " digits of base64",
              "a picture of at most " + std::to_string(most_bytes) + " bytes", faults);
  } else if (const auto wrong = decode_base64(*text, bytes)) {
    constexpr std::size_t shown = 16;
    detail::wrong_type(
        Value(text->substr(*wrong, shown)), at,
        std::string(words) + "; it is not from its character " + std::to_string(*wrong) + " on",
        faults);
  } else {
    return bytes;
  }
  return std::nullopt;
}

Value file_schema(std::string_view example) {
  return Value::Object{{"type", "string"},
                       {"contentEncoding", "base64"},
                       {"pattern", file_pattern},
                       {"examples", Value::Array{example}}};
}

void add_fault(const PictureFault& fault, const Place& at, Faults& faults) {
  if (fault.beyond_limits) add_limit(at, fault.got, fault.allowed, faults);
  else detail::wrong_type(Value(fault.got), at, fault.allowed, faults);
}

bool take_pixels(const PictureSize& size, const Place& at, Faults& faults) {
  return take(Bulk::pixels, size.pixels(), "", at, faults) &&
         take(Bulk::scanned_pixels, size.scanned_pixels(), ", a JPEG's with each of its scans", at,
              faults);
}

}  // namespace tia
