#include "server/stores/model_exchange.h"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>
#include <utility>

#include "core/input/json.h"
#include "core/models/archive.h"
#include "core/models/check_model.h"
#include "core/models/images.h"
#include "server/stores/streamed_answer.h"
#include "server/stores/unpack_exchange.h"

namespace tia::server {
namespace {

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

struct ModelRequest {
  ModelFiles files;
  ModelLimits limits;
};

// The line that a request begins with, which is taken off.
Value take_head(std::span<const std::uint8_t>& bytes) {
  const auto line_end = std::ranges::find(bytes, std::uint8_t{'\n'});
  if (line_end == bytes.end()) throw std::runtime_error("no request: no line");
  const auto line = bytes.first(static_cast<std::size_t>(line_end - bytes.begin()));
  bytes = bytes.subspan(line.size() + 1);
  return parse_json({reinterpret_cast<const char*>(line.data()), line.size()}, {});
}

ModelRequest request_of(const Value& head, std::span<const std::uint8_t> bytes) {
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

// ---- models -------------------------------------------------------------------------------------

using PictureExtent = std::array<std::uint32_t, 2>;  // width, height; of none 0, 0

// After the letter: the archive's length, the archive, the sizes of all pictures, their pixels.
ReaderAnswer model_answer(Model model, const ModelLimits& limits) {
  ReaderAnswer answer;
  Faults faults;
  answer.images = decode_images(model, limits, faults);
  faults.raise();
  for (ModelImage& each : model.images) each.file = {};
  answer.bytes.push_back(model_follows);
  put_number(archive_size(model), answer.bytes);
  for (const auto& image : answer.images)
    for (const int side : {image ? image->width : 0, image ? image->height : 0})
      put_number(static_cast<std::uint32_t>(side), answer.extents);
  answer.model = std::move(model);
  return answer;
}

void take_all(ByteSource& source, std::span<std::uint8_t> room) {
  if (!source.fill(room)) throw NoAnswer("fewer bytes than it says");
}
template <class Number>
Number number_from(ByteSource& source) {
  std::array<std::uint8_t, sizeof(Number)> bytes{};
  take_all(source, bytes);
  return std::bit_cast<Number>(bytes);
}

std::vector<PictureExtent> take_extents(ByteSource& source, std::size_t count,
                                        const ModelLimits& limits) {
  std::vector<PictureExtent> all(count);
  std::uint64_t left = limits.texture_pixels;
  for (PictureExtent& each : all) {
    for (std::uint32_t& side : each) side = number_from<std::uint32_t>(source);
    const std::uint64_t pixels = std::uint64_t{each[0]} * each[1];
    if (std::max(each[0], each[1]) > limits.texture_side || pixels > left)
      throw NoAnswer("pictures beyond the limits");
    left -= pixels;
  }
  return all;
}

// None where one of its sides is 0.
std::shared_ptr<const ImageRgba8> take_picture(ByteSource& source, PictureExtent extent) {
  const auto [width, height] = extent;
  const std::uint64_t bytes = std::uint64_t{4} * width * height;
  if (bytes == 0) return nullptr;
  ImageRgba8 picture{static_cast<int>(width), static_cast<int>(height), {}};
  if (bytes > source.most() || !take_list(source, bytes, picture.rgba))
    throw NoAnswer("fewer bytes than it says");
  return std::make_shared<const ImageRgba8>(std::move(picture));
}

KeptModel take_model(ByteSource& source, const ModelLimits& limits) {
  const auto length = number_from<std::uint64_t>(source);
  auto model = unarchived(source, length);
  if (!model) throw NoAnswer("an archive of another length");
  Faults faults;
  check_model(*model, limits, faults);
  if (!faults.empty()) throw NoAnswer(describe(faults.list().front()));
  KeptModel kept;
  for (const PictureExtent each : take_extents(source, model->images.size(), limits))
    kept.images.push_back(take_picture(source, each));
  std::array<std::uint8_t, 1> more{};
  if (source.read(more) > 0) throw NoAnswer("more bytes than it says");
  kept.model = std::make_shared<const Model>(std::move(*model));
  return kept;
}

[[noreturn]] void take_faults(ByteSource& source) {
  std::vector<std::uint8_t> text, piece(std::size_t{1} << 16U);
  while (const std::size_t got = source.read(piece))
    text.insert(text.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(got));
  raise_faults(text);
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

std::size_t request_length(std::span<const std::uint8_t> begin) {
  if (std::ranges::find(begin, std::uint8_t{'\n'}) == begin.end()) return 0;
  auto rest = begin;
  const Value head = take_head(rest);
  if (asks_to_unpack(head)) return 0;
  std::size_t length = begin.size() - rest.size();
  for (const Value& each : member<Value::Array>(head, "files"))
    length += static_cast<std::size_t>(member<double>(each, "bytes"));
  return length;
}

ReaderAnswer answer_to(std::span<const std::uint8_t> bytes) {
  const Value head = take_head(bytes);
  try {
    if (asks_to_unpack(head)) return unpacked_answer(head, bytes);
    const ModelRequest request = request_of(head, bytes);
    return model_answer(read_model(request.files, request.limits), request.limits);
  } catch (const InputError& error) {
    ReaderAnswer answer;
    answer.bytes = faults_answer(error);
    return answer;
  }
}

KeptModel model_of(ByteSource& answer, const ModelLimits& limits) {
  const auto letter = number_from<std::uint8_t>(answer);
  if (letter == faults_follow) take_faults(answer);
  if (letter != model_follows) throw NoAnswer("neither a model nor faults");
  return take_model(answer, limits);
}

KeptModel model_of(std::span<const std::uint8_t> answer, const ModelLimits& limits) {
  BytesInMemory source(answer);
  return model_of(source, limits);
}

}  // namespace tia::server
