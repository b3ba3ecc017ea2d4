#include "server/stores/model_exchange.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include "core/input/json.h"
#include "core/models/archive.h"
#include "core/models/check_model.h"
#include "core/models/images.h"

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

ReaderAnswer faults_answer(const InputError& error) {
  Value::Array all;
  for (const Fault& each : error.faults()) all.push_back(fault_value(each));
  const std::string text = to_json(all);
  ReaderAnswer answer;
  answer.bytes.reserve(1 + text.size());
  answer.bytes.push_back(faults_follow);
  for (const char c : text) answer.bytes.push_back(static_cast<std::uint8_t>(c));
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

// ---- models -------------------------------------------------------------------------------------

using PictureExtent = std::array<std::uint32_t, 2>;  // width, height; of none 0, 0

template <class Number>
void put_number(Number number, std::vector<std::uint8_t>& bytes) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(&number);
  bytes.insert(bytes.end(), from, from + sizeof number);
}

std::span<const std::uint8_t> take(std::span<const std::uint8_t>& rest, std::uint64_t size) {
  if (size > rest.size()) throw NoAnswer("fewer bytes than it says");
  const auto part = rest.first(size);
  rest = rest.subspan(size);
  return part;
}
template <class Number>
Number take_number(std::span<const std::uint8_t>& rest) {
  Number number;
  std::memcpy(&number, take(rest, sizeof number).data(), sizeof number);
  return number;
}

// After the letter: the archive's length, the archive, the sizes of all pictures, their pixels.
ReaderAnswer model_answer(Model model, const ModelLimits& limits) {
  ReaderAnswer answer{{model_follows}, {}};
  Faults faults;
  answer.images = decode_images(model, limits, faults);
  faults.raise();
  for (ModelImage& each : model.images) each.file = {};
  constexpr std::size_t before = 1 + sizeof(std::uint64_t);
  put_number(std::uint64_t{0}, answer.bytes);
  append_archive(model, answer.bytes);
  const std::uint64_t length = answer.bytes.size() - before;
  std::memcpy(answer.bytes.data() + 1, &length, sizeof length);
  for (const auto& image : answer.images)
    for (const int side : {image ? image->width : 0, image ? image->height : 0})
      put_number(static_cast<std::uint32_t>(side), answer.bytes);
  return answer;
}

std::vector<PictureExtent> take_extents(std::span<const std::uint8_t>& rest, std::size_t count,
                                        const ModelLimits& limits) {
  std::vector<PictureExtent> all(count);
  std::uint64_t left = limits.texture_pixels;
  for (PictureExtent& each : all) {
    for (std::uint32_t& side : each) side = take_number<std::uint32_t>(rest);
    const std::uint64_t pixels = std::uint64_t{each[0]} * each[1];
    if (std::max(each[0], each[1]) > limits.texture_side || pixels > left)
      throw NoAnswer("pictures beyond the limits");
    left -= pixels;
  }
  return all;
}

KeptModel take_model(std::span<const std::uint8_t> rest, const ModelLimits& limits) {
  const auto length = take_number<std::uint64_t>(rest);
  auto model = unarchived(take(rest, length));
  if (!model) throw NoAnswer("an archive of another length");
  Faults faults;
  check_model(*model, limits, faults);
  if (!faults.empty()) throw NoAnswer(describe(faults.list().front()));
  KeptModel kept;
  for (const auto [width, height] : take_extents(rest, model->images.size(), limits)) {
    const auto pixels = take(rest, std::uint64_t{4} * width * height);
    kept.images.push_back(pixels.empty() ? nullptr
                                         : std::make_shared<const ImageRgba8>(
                                               ImageRgba8{static_cast<int>(width),
                                                          static_cast<int>(height),
                                                          {pixels.begin(), pixels.end()}}));
  }
  if (!rest.empty()) throw NoAnswer("more bytes than it says");
  kept.model = std::make_shared<const Model>(std::move(*model));
  return kept;
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

ReaderAnswer answer_to(std::span<const std::uint8_t> bytes) {
  const ModelRequest request = request_of(bytes);
  try {
    return model_answer(read_model(request.files, request.limits), request.limits);
  } catch (const InputError& error) {
    return faults_answer(error);
  }
}

KeptModel model_of(std::span<const std::uint8_t> answer, const ModelLimits& limits) {
  if (answer.empty()) throw NoAnswer("nothing");
  const auto rest = answer.subspan(1);
  if (answer[0] == faults_follow) raise(rest);
  if (answer[0] != model_follows) throw NoAnswer("neither a model nor faults");
  return take_model(rest, limits);
}

}  // namespace tia::server
