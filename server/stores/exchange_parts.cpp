#include "server/stores/exchange_parts.h"

#include "core/input/json.h"

namespace tia::server {
namespace {

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
  if (kind < 0 || kind > static_cast<double>(FaultKind::unreadable))
    throw NoAnswer("a kind of fault");
  Fault fault{static_cast<FaultKind>(static_cast<int>(kind)), member<std::string>(value, "pointer"),
              std::nullopt, member<std::string>(value, "allowed"),
              member<std::string>(value, "nearest")};
  const auto& members = *value.as<Value::Object>();
  if (const Value* got = find(members, "got")) fault.got = *got;
  if (find(members, "line") != nullptr)
    fault.line = static_cast<std::size_t>(member<double>(value, "line"));
  // The request was whole and well formed: it is the file in it that is not.
  if (fault.kind == FaultKind::malformed) fault.kind = FaultKind::unreadable;
  return fault;
}

}  // namespace

std::vector<std::uint8_t> faults_answer(const InputError& error) {
  Value::Array all;
  for (const Fault& each : error.faults()) all.push_back(fault_value(each));
  const std::string text = to_json(all);
  std::vector<std::uint8_t> answer;
  answer.reserve(1 + text.size());
  answer.push_back(faults_follow);
  for (const char c : text) answer.push_back(static_cast<std::uint8_t>(c));
  return answer;
}

// Collected again, for what anybody may have written is to be cut short.
void raise_faults(std::span<const std::uint8_t> text) {
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

}  // namespace tia::server
