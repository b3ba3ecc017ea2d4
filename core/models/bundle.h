// Several files that came together: which of them is the model, and the text that its id is the
// hash of.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/models/model_files.h"
#include "core/models/multipart.h"
#include "core/models/zip.h"

namespace tia {

/// The files of an archive, as views into it. The bytes must outlive them.
std::vector<ModelFile> files_of(const std::vector<UnpackedFile>& unpacked);
/// The files of a form: its parts with a file name, but clutter and fields where no file was
/// chosen. Errors: faults of clean_path(), and `conflict` at "/PATH" for a path that came twice.
std::vector<ModelFile> files_of(const std::vector<FormPart>& parts, Faults& faults);

/// The folders that all paths begin with, each with its '/': "chair/" of chair/chair.gltf and
/// chair/textures/wood.png. Domain: clean paths.
std::string_view lone_folder(const std::vector<ModelFile>& files);
/// Takes those folders off all paths, so that a folder that was packed with its own name, or with
/// those around it, gives the same id as its files. What a file names in another is named from
/// folder to folder and stays where it was; only a name that leads out of the lone folder and back
/// in by its name is lost.
void strip_lone_folder(std::vector<ModelFile>& files);

/// The number of the file that is the model. It is `wanted` where that is not "": a path with or
/// without the lone folder. Else a file that came alone, whatever its name; else the only one that
/// ends in .gltf, .glb, .obj, .ply or .stl, in letters of any case; of several the one that lies
/// higher than the others.
/// Returns: 0, of no meaning, where there is a fault. Domain: clean paths, each once.
/// Errors: one fault at "/main": `unknown_name` where what is wanted did not come, `conflict` where
/// several could be meant, `missing` where none.
std::size_t main_of(const std::vector<ModelFile>& files, std::string_view wanted, Faults& faults);

/// BundledFile: a file of a model by its path, without the lone folder, and its SHA-256 in hex.
struct BundledFile {
  std::string path, sha256;
};
/// The text that the id of a model of several files is the SHA-256 of, as RFC 8785 has it:
/// {"files":{PATH:SHA-256,…},"main":PATH}. Domain: each path once, in UTF-8.
std::string bundle_text(const std::vector<BundledFile>& files, std::string_view main);

}  // namespace tia
