#include "server/text_form.h"

namespace tia::server {
namespace {

std::optional<Value> try_json(std::string_view text) {
  try {
    return parse_json(text);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

Value number_from_text(std::string_view text) {
  const auto value = try_json(text);
  return value && value->as<double>() != nullptr ? *value : Value(text);
}

Value list_from_text(std::string_view text) {
  std::string list(text);
  if (!list.starts_with('[')) list.insert(0, 1, '[').append(1, ']');
  const auto value = try_json(list);
  return value && value->as<Value::Array>() != nullptr ? *value : Value(text);
}

Value json_or_name_from_text(std::string_view text, const Place& at) {
  if (!text.starts_with('{')) return text;
  try {
    return parse_json(text);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer.insert(0, at.pointer());
    throw InputError(std::move(faults));
  }
}

}  // namespace tia::server
