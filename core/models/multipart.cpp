#include "core/models/multipart.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "core/input/utf8.h"
#include "core/models/header_value.h"

namespace tia {
namespace {

constexpr std::size_t most_form_parts = 1024, most_header_bytes = 16 << 10;

bool is_form_text(std::string_view text) {
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    if (point.length == 0) return false;
    text.remove_prefix(point.length);
  }
  return true;
}

bool is_boundary_character(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
         std::string_view("'()+_,-./:=? ").find(c) != std::string_view::npos;
}

// With the escapes of browsers undone, which leave any other '%' as it is.
std::string form_name(std::string_view text) {
  std::string name;
  while (!text.empty()) {
    const std::string escape = in_lower_case(text.substr(0, 3));
    const char meant = escape == "%22" ? '"' : escape == "%0d" ? '\r' : escape == "%0a" ? '\n' : 0;
    name += meant != 0 ? meant : text.front();
    text.remove_prefix(meant != 0 ? escape.size() : 1);
  }
  return name;
}

// What the headers of a part say that counts.
struct PartHeaders {
  std::optional<std::string> disposition, type;

  // Takes a line. Returns: what it has to be and is not, or "".
  std::string_view take(std::string_view line) {
    const std::string_view name = line.substr(0, line.find(':'));
    if (!is_header_token(name) || name.size() == line.size())
      return "headers, each a name, : and a value";
    const std::string_view value = without_blanks(line.substr(name.size() + 1));
    if (std::ranges::any_of(
            value, [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; }))
      return "headers without control characters";
    const std::string known = in_lower_case(name);
    if (known == "content-disposition") return keep(disposition, value);
    if (known == "content-type") return keep(type, value);
    constexpr std::array<std::string_view, 3> plain{"binary", "8bit", "7bit"};
    if (known == "content-transfer-encoding" &&
        std::ranges::count(plain, in_lower_case(value)) == 0)
      return "bytes as they are, in no Content-Transfer-Encoding";
    return "";
  }
  static std::string_view keep(std::optional<std::string>& kept, std::string_view value) {
    if (kept) return "each header once";
    kept = value;
    return "";
  }
};

// A line that separates two parts, or ends the last one.
struct BoundaryLine {
  std::size_t begin, end;  ///< with the line breaks before and after it
  bool last;
};

class FormReader {
 public:
  FormReader(ModelBytes body, std::string_view boundary, Faults& faults)
      : body_(reinterpret_cast<const char*>(body.data()), body.size()),
        mark_("\r\n--" + std::string(boundary)),
        faults_(faults) {}

  std::vector<FormPart> read() {
    auto line = first_line();
    for (; line && !line->last; ++part_) {
      const auto next = line_from(line->end);
      if (!next || faults_.full()) break;
      if (part_ > most_form_parts) {
        refuse(FaultKind::limit, "at most " + std::to_string(most_form_parts) + " parts");
        return {};
      }
      read_part(body_.substr(line->end, next->begin - line->end));
      line = next;
    }
    if (!line || !line->last)
      refuse(FaultKind::malformed,
             "the boundary of the Content-Type before each part, and behind "
             "the last with -- at its end");
    return std::move(parts_);
  }

 private:
  // ---- boundaries -------------------------------------------------------------------------------

  std::optional<BoundaryLine> first_line() const {
    const std::size_t size = mark_.size() - 2;  // at the body's front no line break is before it
    const auto front = body_.starts_with(mark_.substr(2)) ? line_at(0, size) : std::nullopt;
    return front ? front : line_from(0);
  }
  // Linear: a boundary has no CR, so that no byte is compared with more than one mark's beginning.
  std::optional<BoundaryLine> line_from(std::size_t from) const {
    for (;;) {
      const std::size_t begin = body_.find(mark_, from);
      if (begin == body_.npos) return std::nullopt;
      from = begin + mark_.size();
      if (const auto line = line_at(begin, from)) return line;
    }
  }
  // Nothing where more follows in that line than blanks: then it is part of something else.
  std::optional<BoundaryLine> line_at(std::size_t begin, std::size_t end) const {
    const bool last = body_.substr(end).starts_with("--");
    if (last) end += 2;
    end = std::min(body_.size(), body_.find_first_not_of(" \t", end));
    if (last && end == body_.size()) return BoundaryLine{begin, end, last};
    if (!body_.substr(end).starts_with("\r\n")) return std::nullopt;
    return BoundaryLine{begin, end + 2, last};
  }

  // ---- parts ------------------------------------------------------------------------------------

  void read_part(std::string_view text) {
    const auto headers = take_headers(text);
    if (!headers) return;
    const auto value =
        headers->disposition ? parse_header_value(*headers->disposition) : std::nullopt;
    const std::string* name = value && value->word == "form-data" ? value->find("name") : nullptr;
    if (name == nullptr || !is_form_text(*headers->disposition))
      return refuse(FaultKind::malformed,
                    "a Content-Disposition of form-data with a name, in UTF-8");
    FormPart part{form_name(*name),
                  std::nullopt,
                  headers->type.value_or(""),
                  {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}};
    if (const std::string* filename = value->find("filename")) part.filename = form_name(*filename);
    parts_.push_back(std::move(part));
  }
  // Up to an empty line, or to the end where a part has headers only.
  std::optional<PartHeaders> take_headers(std::string_view& text) {
    PartHeaders headers;
    for (std::size_t left = most_header_bytes; !text.empty();) {
      const std::size_t size = text.substr(0, left).find("\r\n");
      if (size == text.npos) {
        refuse_open_headers(text.size() >= left);
        return std::nullopt;
      }
      const std::string_view line = text.substr(0, size);
      text.remove_prefix(size + 2);
      left -= size + 2;
      if (line.empty()) break;
      if (const std::string_view wanted = headers.take(line); !wanted.empty()) {
        refuse(FaultKind::malformed, std::string(wanted));
        return std::nullopt;
      }
    }
    return headers;
  }
  void refuse_open_headers(bool too_long) {
    if (too_long)
      refuse(FaultKind::limit,
             "at most " + std::to_string(most_header_bytes) + " bytes of headers");
    else refuse(FaultKind::malformed, "headers, each ended by CR LF, and an empty line");
  }

  void refuse(FaultKind kind, std::string allowed) {
    faults_.add({kind, "", Value("part " + std::to_string(part_)), std::move(allowed)});
  }

  std::string_view body_;
  std::string mark_;  // how a line begins that separates
  Faults& faults_;
  std::size_t part_ = 1;
  std::vector<FormPart> parts_;
};

}  // namespace

std::optional<std::string> boundary_of(std::string_view content_type) {
  constexpr std::size_t longest = 70;
  const auto value = parse_header_value(content_type);
  const std::string* boundary =
      value && value->word == "multipart/form-data" ? value->find("boundary") : nullptr;
  if (boundary == nullptr || boundary->empty() || boundary->size() > longest ||
      boundary->ends_with(' ') || !std::ranges::all_of(*boundary, is_boundary_character))
    return std::nullopt;
  return *boundary;
}

std::vector<FormPart> parse_multipart(ModelBytes body, std::string_view boundary, Faults& faults) {
  const std::size_t before = faults.count();
  auto parts = FormReader(body, boundary, faults).read();
  return faults.count() == before ? std::move(parts) : std::vector<FormPart>();
}

}  // namespace tia
