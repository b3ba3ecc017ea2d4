// Text -> Value through nlohmann-json's SAX parser, whose events are taken one by one so that
// depth, count and duplicate keys are bounded while parsing and a fault knows its place.
#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>
#include <vector>

#include "core/input/errors.h"
#include "core/input/item_counts.h"
#include "core/input/json.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

using Json = nlohmann::json;

// What texts it is given it copies: the parser's own have room to grow.
class ValueBuilder final : public nlohmann::json_sax<Json> {
 public:
  ValueBuilder(std::string_view text, const JsonLimits& limits, const std::stop_token& stop)
      : limits_(limits), stop_(stop), item_counts_(item_counts(text, limits.values)) {}

  Value take() { return std::move(root_); }

  bool null() override { return add(Value()); }
  bool boolean(bool b) override { return add(Value(b)); }
  bool number_integer(std::int64_t i) override { return add(Value(static_cast<double>(i))); }
  bool number_unsigned(std::uint64_t u) override { return add(Value(static_cast<double>(u))); }
  bool number_float(double d, const std::string&) override { return add(Value(d)); }
  bool string(std::string& s) override { return add(Value(std::string_view(s))); }
  bool binary(Json::binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(Value::Object{}); }
  bool start_array(std::size_t) override { return open(Value::Array{}); }
  bool end_array() override { return close(); }

  bool key(std::string& name) override {
    auto& members = *open_.back()->as<Value::Object>();
    members.emplace_back(std::piecewise_construct, std::forward_as_tuple(std::string_view(name)),
                         std::tuple());
    return true;
  }

  bool end_object() override {
    auto& members = *open_.back()->as<Value::Object>();
    std::vector<std::string_view> names;
    names.reserve(members.size());
    for (const auto& [name, value] : members) names.push_back(name);
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) {
      const std::string name = excerpt_of(*twice, longest_name);
      members.back().first = name;  // the place that the fault names
      fail(FaultKind::malformed, Value(name), "each key once in an object");
    }
    return close();
  }

  bool parse_error(std::size_t, const std::string&, const Json::exception& error) override {
    std::string_view said = error.what();  // "[json.exception.…] words": the words will do
    if (const auto end = said.find("] "); end != said.npos) said.remove_prefix(end + 2);
    constexpr std::size_t longest = 240;  // it repeats the word that it stumbled over
    fail(FaultKind::malformed, std::nullopt, "JSON text: " + excerpt_of(said, longest));
  }

 private:
  bool add(Value value) {
    place(std::move(value));
    return true;
  }

  // Containers have their place from the start: one that grows takes up to three times as much.
  template <class Container>
  bool open(Container items) {
    if (open_.size() >= limits_.depth)
      fail(FaultKind::malformed, std::nullopt,
           "at most " + std::to_string(limits_.depth) + " levels of arrays and objects");
    Value* const placed = place(Value(std::move(items)));
    open_.push_back(placed);
    if (begun_ < item_counts_.size()) placed->as<Container>()->reserve(item_counts_[begun_++]);
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string option_words() const {
    return limits_.option.empty() ? "" : " (option " + std::string(limits_.option) + ")";
  }

  // Puts the value where it belongs. The pointer stays good: a container grows only while it is
  // the innermost open one.
  Value* place(Value value) {
    if (++placed_ % 4096 == 0) end_if_asked(stop_);
    Value* const parent = open_.empty() ? nullptr : open_.back();
    auto* const array = parent != nullptr ? parent->as<Value::Array>() : nullptr;
    const bool in_flat_array = array != nullptr && value.as<double>() != nullptr;
    if (!in_flat_array && ++count_ > limits_.values)
      fail(FaultKind::limit, std::nullopt,
           "at most " + std::to_string(limits_.values) +
               " JSON values, numbers inside arrays not counted" + option_words());
    if (parent == nullptr) return &(root_ = std::move(value));
    if (array != nullptr) return &array->emplace_back(std::move(value));
    return &(parent->as<Value::Object>()->back().second = std::move(value));
  }

  // The place that is being read: inside the innermost container, its newest member or its next
  // element.
  std::string pointer() const {
    std::string text;
    for (const Value* container : open_) {
      if (const auto* object = container->as<Value::Object>()) {
        if (!object->empty()) text += Place{}.at(object->back().first).pointer();
      } else {
        const std::size_t size = container->as<Value::Array>()->size();
        text += Place{}.at(container == open_.back() ? size : size - 1).pointer();
      }
    }
    return text;
  }

  [[noreturn]] void fail(FaultKind kind, std::optional<Value> got, std::string allowed) const {
    throw InputError({kind, pointer(), std::move(got), std::move(allowed)});
  }

  JsonLimits limits_;
  std::stop_token stop_;
  std::vector<std::uint32_t> item_counts_;  // of the containers in their order
  std::size_t begun_ = 0, placed_ = 0;
  Value root_;
  std::vector<Value*> open_;  // the containers around the current place, outermost first
  std::size_t count_ = 0;
};

}  // namespace

Value parse_json(std::string_view text, const JsonLimits& limits, const std::stop_token& stop) {
  if (text.find('\0') != text.npos)  // where the library would take the text for ended
    throw InputError({FaultKind::malformed, "", std::nullopt, "JSON text: no NUL byte"});
  ValueBuilder builder(text, limits, stop);
  Json::sax_parse(text.begin(), text.end(), &builder);
  return builder.take();
}

}  // namespace tia
