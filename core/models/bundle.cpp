#include "core/models/bundle.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "core/input/json.h"
#include "core/models/paths.h"

namespace tia {
namespace {

constexpr std::array<std::string_view, 5> model_endings{".gltf", ".glb", ".obj", ".ply", ".stl"};

bool ends_as_models_do(std::string_view path) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::ranges::any_of(model_endings, [&](std::string_view ending) {
    return path.size() >= ending.size() &&
           std::ranges::equal(path.substr(path.size() - ending.size()), ending, same);
  });
}

auto folders_above(std::string_view path) { return std::ranges::count(path, '/'); }

std::vector<std::string_view> sorted_paths_of(const std::vector<ModelFile>& files,
                                              const std::vector<std::size_t>& which) {
  std::vector<std::string_view> paths;
  for (const std::size_t i : which) paths.push_back(files[i].path);
  std::ranges::sort(paths);
  return paths;
}
std::vector<std::size_t> file_numbers(std::size_t count) {
  std::vector<std::size_t> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = i;
  return all;
}

// First by the paths that the id has, so that how the folder was packed makes no difference.
std::optional<std::size_t> wanted_file(const std::vector<ModelFile>& files,
                                       std::string_view wanted) {
  for (const std::size_t folder : {lone_folder(files).size(), std::size_t{0}})
    for (std::size_t i = 0; i < files.size(); ++i)
      if (std::string_view(files[i].path).substr(folder) == wanted) return i;
  return std::nullopt;
}

std::size_t no_main(Faults& faults, Fault fault) {
  fault.pointer = "/main";
  faults.add(std::move(fault));
  return 0;
}

// The only one that lies higher than the others, or all where there is none such.
std::vector<std::size_t> highest_files(const std::vector<ModelFile>& files,
                                       const std::vector<std::size_t>& which) {
  const auto height = [&](std::size_t i) { return folders_above(files[i].path); };
  const std::size_t first = *std::ranges::min_element(which, {}, height);
  const auto as_high = std::ranges::count(which, height(first), height);
  return as_high == 1 ? std::vector<std::size_t>{first} : which;
}

}  // namespace

std::vector<ModelFile> files_of(const std::vector<UnpackedFile>& unpacked) {
  std::vector<ModelFile> files;
  files.reserve(unpacked.size());
  for (const UnpackedFile& each : unpacked) files.push_back({each.path, each.bytes});
  return files;
}

std::vector<ModelFile> files_of(const std::vector<FormPart>& parts, Faults& faults) {
  std::vector<ModelFile> files;
  for (const FormPart& part : parts) {
    if (faults.full()) return files;
    if (!part.filename || (part.filename->empty() && part.bytes.empty())) continue;
    auto path = clean_path(*part.filename, faults);
    if (path && !is_clutter(*path)) files.push_back({std::move(*path), part.bytes});
  }
  const auto paths = sorted_paths_of(files, file_numbers(files.size()));
  for (std::size_t i = 1; i < paths.size(); ++i)
    if (paths[i] == paths[i - 1])
      faults.add(
          {FaultKind::conflict, Place().at(paths[i]).pointer(), Value(paths[i]), "each path once"});
  return files;
}

std::string_view lone_folder(const std::vector<ModelFile>& files) {
  if (files.empty()) return {};
  std::string_view common = files.front().path;
  for (const ModelFile& file : files) {
    const auto end = std::ranges::mismatch(common, file.path).in1;
    common = common.substr(0, static_cast<std::size_t>(end - common.begin()));
  }
  return common.substr(0, common.rfind('/') + 1);  // npos + 1 = 0
}

void strip_lone_folder(std::vector<ModelFile>& files) {
  const std::size_t folder = lone_folder(files).size();
  for (ModelFile& file : files) file.path.erase(0, folder);
}

std::size_t main_of(const std::vector<ModelFile>& files, std::string_view wanted, Faults& faults) {
  const auto all = file_numbers(files.size());
  if (!wanted.empty()) {
    if (const auto found = wanted_file(files, wanted)) return *found;
    const auto paths = sorted_paths_of(files, all);
    return no_main(faults, {FaultKind::unknown_name, "", Value(wanted), "one of " + listed(paths),
                            nearest_name(wanted, paths)});
  }
  if (files.size() == 1) return 0;
  std::vector<std::size_t> models;
  std::ranges::copy_if(all, std::back_inserter(models),
                       [&](std::size_t i) { return ends_as_models_do(files[i].path); });
  if (models.empty())
    return no_main(faults, {FaultKind::missing, "", std::nullopt,
                            "a file that ends in .gltf, .glb, .obj, .ply or .stl, or main = the "
                            "path of one that is a model"});
  models = highest_files(files, models);
  if (models.size() > 1)
    return no_main(faults, {FaultKind::conflict, "", Value(static_cast<double>(models.size())),
                            "main = one of " + listed(sorted_paths_of(files, models))});
  return models.front();
}

std::string bundle_text(const std::vector<BundledFile>& files, std::string_view main) {
  Value::Object digests;
  for (const BundledFile& file : files) digests.emplace_back(file.path, Value(file.sha256));
  return to_json(Value(Value::Object{{"files", Value(std::move(digests))}, {"main", Value(main)}}));
}

}  // namespace tia
