#include "server/stores/model_exchange.h"

#include <algorithm>
#include <string_view>

#include "core/input/json.h"
#include "core/models/archive.h"
#include "core/models/check_model.h"

namespace tia::server {
namespace {

constexpr std::uint8_t model_follows = 'M', faults_follow = 'F';

// The limits by their names, which both sides walk.
template <class Limits, class F>
void for_each_limit(Limits& limits, F f) {
  f("triangles", limits.triangles);
  f("vertices", limits.vertices);
  f("nodes", limits.nodes);
  f("depth", limits.depth);
  f("instances", limits.instances);
  f("polygon_corners", limits.polygon_corners);
  f("json_values", limits.json_values);
  f("texture_pixels", limits.texture_pixels);
  f("texture_side", limits.texture_side);
}

// ---- requests -----------------------------------------------------------------------------------

template <class T>
const T& member(const Value& object, std::string_view name) {
  const auto* members = object.as<Value::Object>();
  const Value* value = members == nullptr ? nullptr : find(*members, name);
  const T* found = value == nullptr ? nullptr : value->as<T>();
  if (found == nullptr) throw std::runtime_error("no request: " + std::string(name));
  return *found;
}

struct ModelRequest {
  ModelFiles files;
  ModelLimits limits;
};

ModelRequest request_of(std::span<const std::uint8_t> bytes) {
  const auto line_end = std::ranges::find(bytes, std::uint8_t{'\n'});
  if (line_end == bytes.end()) throw std::runtime_error("no request: no line");
  const auto head_size = static_cast<std::size_t>(line_end - bytes.begin());
  const Value head = parse_json({reinterpret_cast<const char*>(bytes.data()), head_size}, {});
  bytes = bytes.subspan(head_size + 1);
  ModelRequest request;
  for (const Value& each : member<Value::Array>(head, "files")) {
    const auto size = static_cast<std::size_t>(member<double>(each, "bytes"));
    if (size > bytes.size()) throw std::runtime_error("no request: files that are cut");
    request.files.all.push_back({member<std::string>(each, "path"), bytes.first(size)});
    bytes = bytes.subspan(size);
  }
  request.files.main = static_cast<std::size_t>(member<double>(head, "main"));
  if (request.files.main >= request.files.all.size()) throw std::runtime_error("no main file");
  for_each_limit(request.limits, [&](const char* name, auto& limit) {
    limit = static_cast<std::size_t>(member<double>(head, name));
  });
  return request;
}

// ---- faults -------------------------------------------------------------------------------------

Value fault_value(const Fault& fault) {
  Value::Object value{{"kind", static_cast<double>(fault.kind)},
                      {"pointer", fault.pointer},
                      {"allowed", fault.allowed},
                      {"nearest", fault.nearest}};
  if (fault.got) value.emplace_back("got", *fault.got);
  if (fault.line) value.emplace_back("line", static_cast<double>(*fault.line));
  return value;
}

Fault fault_of(const Value& value) {
  const double kind = member<double>(value, "kind");
  if (kind < 0 || kind > static_cast<double>(FaultKind::limit)) throw NoAnswer("a kind of fault");
  Fault fault{static_cast<FaultKind>(static_cast<int>(kind)), member<std::string>(value, "pointer"),
              std::nullopt, member<std::string>(value, "allowed"),
              member<std::string>(value, "nearest")};
  const auto& members = *value.as<Value::Object>();
  if (const Value* got = find(members, "got")) fault.got = *got;
  if (find(members, "line") != nullptr)
    fault.line = static_cast<std::size_t>(member<double>(value, "line"));
  return fault;
}

std::vector<std::uint8_t> faults_answer(const InputError& error) {
  Value::Array all;
  for (const Fault& each : error.faults()) all.push_back(fault_value(each));
  const std::string text = to_json(all);
  std::vector<std::uint8_t> answer;
  answer.reserve(1 + text.size());
  answer.push_back(faults_follow);
  answer.insert(answer.end(), text.begin(), text.end());
  return answer;
}

// Collected again, for what anybody may have written is to be cut short.
[[noreturn]] void raise(std::span<const std::uint8_t> text) {
  Faults faults;
  try {
    const Value all = parse_json({reinterpret_cast<const char*>(text.data()), text.size()}, {});
    if (const auto* list = all.as<Value::Array>())
      for (const Value& each : *list) faults.add(fault_of(each));
  } catch (const std::exception& error) {
    throw NoAnswer(error.what());
  }
  faults.raise();
  throw NoAnswer("no faults");
}

}  // namespace

std::string request_head(const ModelFiles& files, const ModelLimits& limits) {
  Value::Array list;
  for (const ModelFile& each : files.all)
    list.push_back(
        Value::Object{{"path", each.path}, {"bytes", static_cast<double>(each.bytes.size())}});
  Value::Object head{{"files", std::move(list)}, {"main", static_cast<double>(files.main)}};
  for_each_limit(limits, [&](const char* name, auto limit) {
    head.emplace_back(name, static_cast<double>(limit));
  });
  return to_json(head) + '\n';
}

std::vector<std::uint8_t> answer_to(std::span<const std::uint8_t> bytes) {
  const ModelRequest request = request_of(bytes);
  try {
    std::vector<std::uint8_t> answer{model_follows};
    append_archive(read_model(request.files, request.limits), answer);
    return answer;
  } catch (const InputError& error) {
    return faults_answer(error);
  }
}

Model model_of(std::span<const std::uint8_t> answer, const ModelLimits& limits) {
  if (answer.empty()) throw NoAnswer("nothing");
  const auto rest = answer.subspan(1);
  if (answer[0] == faults_follow) raise(rest);
  if (answer[0] != model_follows) throw NoAnswer("neither a model nor faults");
  auto model = unarchived(rest);
  if (!model) throw NoAnswer("an archive of another length");
  Faults faults;
  check_model(*model, limits, faults);
  if (!faults.empty()) throw NoAnswer(describe(faults.list().front()));
  return std::move(*model);
}

}  // namespace tia::server
