#include "server/stores/unpack_exchange.h"

#include <set>
#include <string_view>

#include "core/input/json.h"
#include "core/models/paths.h"
#include "server/stores/exchange_parts.h"

namespace tia::server {
namespace {

/// FileSizes: of its path and of itself.
struct FileSizes {
  std::uint64_t path = 0, bytes = 0;
};

std::vector<FileSizes> take_sizes(std::span<const std::uint8_t>& rest, const ZipLimits& limits) {
  const auto count = take_number<std::uint64_t>(rest);
  if (count > limits.files) throw NoAnswer("more files than it may have");
  std::vector<FileSizes> all(count);
  std::uint64_t left = limits.bytes;
  for (FileSizes& each : all) {
    each.path = take_number<std::uint64_t>(rest);
    each.bytes = take_number<std::uint64_t>(rest);
    if (each.bytes > left) throw NoAnswer("files beyond the limits");
    left -= each.bytes;
  }
  return all;
}

void check_path(const std::string& path) {
  Faults faults;
  if (clean_path(path, faults) != path || is_clutter(path)) throw NoAnswer("no clean path");
}

}  // namespace

std::string unpack_head(const ZipLimits& limits) {
  return to_json(Value::Object{{"unpack", true},
                               {"bytes", static_cast<double>(limits.bytes)},
                               {"files", static_cast<double>(limits.files)},
                               {"ratio", static_cast<double>(limits.ratio)}}) +
         '\n';
}

bool asks_to_unpack(const Value& head) {
  const auto* members = head.as<Value::Object>();
  return members != nullptr && find(*members, "unpack") != nullptr;
}

ReaderAnswer unpacked_answer(const Value& head, ModelBytes archive) {
  const auto limit = [&](const char* name) {
    return static_cast<std::uint64_t>(member<double>(head, name));
  };
  Faults faults;
  ReaderAnswer answer;
  answer.bytes.push_back(files_follow);
  answer.files = unpack_zip(archive, {limit("bytes"), limit("files"), limit("ratio")}, faults);
  faults.raise();
  put_number(std::uint64_t{answer.files.size()}, answer.bytes);
  for (const UnpackedFile& file : answer.files) {
    put_number(std::uint64_t{file.path.size()}, answer.bytes);
    put_number(std::uint64_t{file.bytes.size()}, answer.bytes);
  }
  for (const UnpackedFile& file : answer.files)
    answer.bytes.insert(answer.bytes.end(), file.path.begin(), file.path.end());
  return answer;
}

std::size_t longest_unpacked(const ZipLimits& limits) {
  constexpr std::uint64_t of_a_file = longest_path + 2 * sizeof(std::uint64_t), of_faults = 1 << 20;
  return limits.bytes + limits.files * of_a_file + of_faults;
}

std::vector<ModelFile> unpacked_files(std::span<const std::uint8_t> answer,
                                      const ZipLimits& limits) {
  if (answer.empty()) throw NoAnswer("nothing");
  auto rest = answer.subspan(1);
  if (answer[0] == faults_follow) raise_faults(rest);
  if (answer[0] != files_follow) throw NoAnswer("neither files nor faults");
  const std::vector<FileSizes> sizes = take_sizes(rest, limits);
  std::vector<ModelFile> files;
  std::set<std::string_view> known;
  for (const FileSizes& each : sizes) {
    const auto path = take(rest, each.path);
    files.push_back({{path.begin(), path.end()}, {}});
    check_path(files.back().path);
    const std::string_view text(reinterpret_cast<const char*>(path.data()), path.size());
    if (!known.insert(text).second) throw NoAnswer("a path twice");
  }
  for (std::size_t i = 0; i < files.size(); ++i) files[i].bytes = take(rest, sizes[i].bytes);
  if (!rest.empty()) throw NoAnswer("more bytes than it says");
  return files;
}

}  // namespace tia::server
