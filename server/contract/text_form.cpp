#include "server/contract/text_form.h"

#include "core/input/packed_text.h"
#include "server/http/message.h"

namespace tia::server {
namespace {

std::optional<Value> try_json(std::string_view text) {
  try {
    return parse_json(text);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

Value json_from_text(std::string_view text, const Place& at) {
  try {
    return parse_json(text);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer.insert(0, at.pointer());
    throw InputError(std::move(faults));
  }
}

Value json_from_packed(std::string_view packed, const Place& at) {
  const auto unpacked = unpack_text(packed);
  if (const auto* text = std::get_if<std::string>(&unpacked)) return json_from_text(*text, at);
  const auto& fault = std::get<PackedFault>(unpacked);
  throw InputError({fault.beyond_limits ? FaultKind::limit : FaultKind::malformed, at.pointer(),
                    Value(fault.got), fault.allowed});
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

// The parser would skip spaces, of which a query's + is one.
Value number_from_text(std::string_view text) {
  if (text.empty() || !(is_digit(text.front()) || text.front() == '-') || !is_digit(text.back()))
    return text;
  const auto value = try_json(text);
  return value && value->as<double>() != nullptr ? *value : Value(text);
}

Value truth_from_text(std::string_view text) {
  if (text == "true" || text == "false") return text == "true";
  return text;
}

Value list_from_text(std::string_view text) {
  std::string list(text);
  if (!list.starts_with('[')) list.insert(0, 1, '[').append(1, ']');
  const auto value = try_json(list);
  return value && value->as<Value::Array>() != nullptr ? *value : Value(text);
}

Value places_from_text(std::string_view text) {
  Value read = list_from_text(text);
  const auto* list = read.as<Value::Array>();
  if (list == nullptr) return read;
  if (!list->empty() && list->front().as<Value::Array>() != nullptr) return read;
  return Value::Array{std::move(read)};
}

Value json_list_from_text(std::string_view text, const Place& at) {
  return text.starts_with('[') ? json_from_text(text, at) : Value(text);
}

Value words_from_text(std::string_view text) {
  Value::Array words;
  if (trimmed(text).empty()) return words;
  if (text.starts_with('['))  // or a host's address
    if (auto list = try_json(text)) return std::move(*list);
  for (std::size_t comma = 0; comma != text.npos;
       text.remove_prefix(std::min(comma + 1, text.size()))) {
    comma = text.find(',');
    words.emplace_back(trimmed(text.substr(0, comma)));
  }
  return words;
}

Value json_or_name_from_text(std::string_view text, const Place& at) {
  constexpr std::string_view packed = "z:";
  if (text.starts_with(packed)) return json_from_packed(text.substr(packed.size()), at);
  return text.starts_with('{') ? json_from_text(text, at) : Value(text);
}

Value::Object list_in_query(Value::Object schema) {
  return {{"style", "form"}, {"explode", false}, {"schema", std::move(schema)}};
}

Value::Object places_in_query(const Value::Object& schema) {
  const Value place =
      Value::Object{{"type", "string"}, {"pattern", "^-?[0-9][^,]*,-?[0-9][^,]*,-?[0-9][^,]*$"}};
  Value::Object list{{"type", "array"}, {"items", place}};
  if (const Value* standard = find(schema, "default")) list.emplace_back("default", *standard);
  return {{"style", "form"}, {"explode", true}, {"schema", std::move(list)}};
}

Value::Object json_in_query(Value::Object schema) {
  const Value::Object json{{"schema", std::move(schema)}};
  return {{"content", Value::Object{{"application/json", json}}}};
}

Value::Object json_or_name_in_query(Value::Object schema) {
  const Value::Array& either = *find(schema, "oneOf")->as<Value::Array>();
  const Value json = Value::Object{
      {"type", "string"}, {"contentMediaType", "application/json"}, {"contentSchema", either[1]}};
  const Value packed =
      Value::Object{{"type", "string"},
                    {"pattern", "^z:[A-Za-z0-9_-]+={0,2}$"},
                    {"description", "the same JSON as base64url of its zlib, as Kroki has it"}};
  Value::Object text{{"anyOf", Value::Array{either[0], json, packed}}};
  if (const Value* standard = find(schema, "default")) text.emplace_back("default", *standard);
  return {{"schema", std::move(text)}};
}

std::string text_of(const Value& value) {
  if (const auto* text = value.as<std::string>()) return *text;
  const auto* list = value.as<Value::Array>();
  if (list == nullptr) return to_json(value);
  std::string text;
  for (const Value& each : *list) {
    if (!text.empty()) text += ',';
    text += text_of(each);
  }
  return text;
}

}  // namespace tia::server
