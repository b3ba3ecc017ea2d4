#include "server/contract/parameters.h"

#include <algorithm>

#include "core/input/json.h"
#include "server/http/error.h"

namespace tia::server {
namespace {

std::string form_decode(std::string text, std::string_view pointer = "") {
  std::replace(text.begin(), text.end(), '+', ' ');
  return percent_decode(text, pointer);
}

}  // namespace

bool QueryReader::next() {
  while (left_.starts_with('&')) left_.remove_prefix(1);
  if (left_.empty()) return false;
  const std::string_view pair = left_.substr(0, left_.find('&'));
  left_.remove_prefix(pair.size());
  const auto equals = std::min(pair.find('='), pair.size());
  name_ = form_decode(std::string(pair.substr(0, equals)));
  text_ = form_decode(std::string(pair.substr(std::min(equals + 1, pair.size()))),
                      Place{}.at(name_).pointer());
  return true;
}

void QueryReader::add_to_group(Value value) {
  const std::string name = group();
  const Place all{}, at = all.at(name);
  for (auto& [each, members] : object_) {
    if (each != name) continue;
    if (auto* object = members.as<Value::Object>())
      return add_once(*object, at, rest(), std::move(value));
    throw InputError({FaultKind::malformed, at.pointer(), members, "each parameter once"});
  }
  object_.emplace_back(name, Value::Object{{rest(), std::move(value)}});
}

// What is no list stays what it is, for its reader to refuse at its place.
void QueryReader::add_again(Value value) {
  const auto known = std::ranges::find(object_, name_, &Value::Object::value_type::first);
  if (known == object_.end()) return add(std::move(value));
  auto* const all = known->second.as<Value::Array>();
  if (all == nullptr) return;
  if (const auto* more = value.as<Value::Array>())
    all->insert(all->end(), more->begin(), more->end());
  else all->push_back(std::move(value));
}

void QueryReader::add_once(Value::Object& object, const Place& at, const std::string& name,
                           Value value) {
  if (find(object, name) != nullptr)
    throw InputError(
        {FaultKind::malformed, at.at(name).pointer(), Value(text_), "each parameter once"});
  object.emplace_back(name, std::move(value));
}

void refuse_query(const Request& request) {
  if (!request.query().empty())
    throw InputError({FaultKind::conflict, "", Value(request.query()),
                      "with POST all in the body, nothing in the URL"});
}

Value body_json(const Request& request, const std::string& what, const JsonLimits& limits) {
  refuse_query(request);
  const auto start = request.body.find_first_not_of(" \t\r\n");
  const bool declared_json = request.header("Content-Type").find("json") != std::string_view::npos;
  if (start == std::string::npos || (request.body[start] != '{' && !declared_json))
    throw HttpError("media-type", "send " + what);
  return parse_json(request.body, limits, request.stop);
}

}  // namespace tia::server
