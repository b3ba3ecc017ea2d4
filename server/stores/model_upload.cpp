#include "server/stores/model_upload.h"

#include <algorithm>
#include <utility>

#include "core/input/json.h"
#include "core/models/bundle.h"
#include "core/models/formats.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

std::string_view text_of_file(ModelBytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
ModelBytes bytes_of_text(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// BundleSaid: what a bundle_text() says: paths and hashes in its order, which is RFC 8785's.
struct BundleSaid {
  Value::Object hashes;
  std::string main;
};
std::optional<BundleSaid> bundle_of(std::string_view text) {
  const Value all = parse_json(text);
  const auto* const members = all.as<Value::Object>();
  const Value* const files = members == nullptr ? nullptr : find(*members, "files");
  const Value* const main = members == nullptr ? nullptr : find(*members, "main");
  if (files == nullptr || main == nullptr) return std::nullopt;
  const auto* const hashes = files->as<Value::Object>();
  const auto* const path = main->as<std::string>();
  if (hashes == nullptr || path == nullptr) return std::nullopt;
  return BundleSaid{*hashes, *path};
}

void set_main(const std::string& path, ModelFiles& files) {
  const auto at = std::ranges::find(files.all, path, &ModelFile::path);
  files.main = static_cast<std::size_t>(at - files.all.begin());
}

void sort_as(const BundleSaid& said, ModelFiles& files) {
  std::vector<ModelFile> sorted;
  for (const auto& [path, sha256] : said.hashes)
    sorted.push_back(*std::ranges::find(files.all, path, &ModelFile::path));
  files.all = std::move(sorted);
  set_main(said.main, files);
}

// Takes the next line off the text, without its end; none where there is no end.
std::optional<std::string_view> take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  if (end == text.npos) return std::nullopt;
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 1);
  return line;
}

// Takes files of these sizes off the text, each as its hash says.
bool take_files(const Value::Object& hashes, const Value::Array& sizes, std::string_view text,
                ModelFiles& files) {
  for (std::size_t i = 0; i < hashes.size(); ++i) {
    const double* size = sizes[i].as<double>();
    if (size == nullptr || !(*size >= 0 && *size <= static_cast<double>(text.size()))) return false;
    const std::string_view file = text.substr(0, static_cast<std::size_t>(*size));
    text.remove_prefix(file.size());
    if (Value(sha256_hex(file)) != hashes[i].second) return false;
    files.all.push_back({hashes[i].first, bytes_of_text(file)});
  }
  return text.empty();
}

// The first line is what the id is the hash of: so it is what upload_of() has written.
std::optional<ModelUpload> unpacked_bundle(const std::string& id, std::string_view packed) {
  std::string_view rest = packed;
  const auto bundle = take_line(rest), sizes = take_line(rest);
  if (!sizes || sha256_hex(*bundle) != id) return std::nullopt;
  const auto said = bundle_of(*bundle);
  const Value lengths = parse_json(*sizes);
  const auto* const list = lengths.as<Value::Array>();
  ModelUpload upload{{}, id, std::string(packed.substr(0, packed.size() - rest.size()))};
  if (!said || list == nullptr || list->size() != said->hashes.size()) return std::nullopt;
  if (!take_files(said->hashes, *list, rest, upload.files)) return std::nullopt;
  set_main(said->main, upload.files);
  return upload;
}

}  // namespace

bool is_model_id(std::string_view text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == text.npos;
}

std::size_t ModelUpload::bytes() const {
  std::size_t bytes = 0;
  for (const ModelFile& file : files.all) bytes += file.bytes.size();
  return bytes;
}

std::vector<std::string_view> ModelUpload::packed() const {
  std::vector<std::string_view> pieces{head};
  for (const ModelFile& file : files.all) pieces.push_back(text_of_file(file.bytes));
  return pieces;
}

ModelUpload upload_of(ModelFiles files, std::string known_sha256) {
  if (files.all.size() == 1) {
    std::string id = known_sha256.empty() ? sha256_hex(text_of_file(files.main_file().bytes))
                                          : std::move(known_sha256);
    return {std::move(files), std::move(id), ""};
  }
  std::vector<BundledFile> named;
  for (const ModelFile& file : files.all)
    named.push_back({file.path, sha256_hex(text_of_file(file.bytes))});
  const std::string text = bundle_text(named, files.main_file().path);
  sort_as(*bundle_of(text), files);
  Value::Array sizes;
  for (const ModelFile& file : files.all)
    sizes.emplace_back(static_cast<double>(file.bytes.size()));
  return {std::move(files), sha256_hex(text), text + '\n' + to_json(sizes) + '\n'};
}

std::optional<ModelUpload> unpacked_upload(const std::string& id, std::string_view packed) {
  // A bundle that was cut behind its text is no model.
  const bool is_lone = format_of(bytes_of_text(packed)) != nullptr && sha256_hex(packed) == id;
  if (is_lone) return ModelUpload{{{{"model", bytes_of_text(packed)}}, 0}, id, ""};
  try {
    return unpacked_bundle(id, packed);
  } catch (const InputError&) {  // lines that are no JSON
    return std::nullopt;
  }
}

}  // namespace tia::server
