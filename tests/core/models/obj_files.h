// What the tests of OBJ and MTL share: files from texts, and what a sound model is.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/models/model.h"
#include "core/models/model_files.h"
#include "core/models/obj.h"
#include "tests/core/models/file_bytes.h"

namespace tia::test {

/// TextFiles: paths with texts, the first of them the main file.
struct TextFiles {
  std::vector<std::pair<std::string, std::string>> texts;
  ModelFiles files() const {
    ModelFiles files;
    for (const auto& [path, text] : texts) files.all.push_back({path, bytes_of(text)});
    return files;
  }
};

/// ReadObj: what came of reading.
struct ReadObj {
  Model model;
  Faults faults;
};
inline ReadObj read_obj_files(const TextFiles& texts, const ModelLimits& limits = {}) {
  ReadObj read;
  const ModelFiles files = texts.files();
  read_obj(files, limits, read.faults, read.model);
  return read;
}
inline ReadObj read_obj_text(const std::string& text, const ModelLimits& limits = {}) {
  return read_obj_files({{{"a.obj", text}}}, limits);
}
/// Of a text without faults.
inline Model obj_model(const TextFiles& texts) {
  ReadObj read = read_obj_files(texts);
  for (const Fault& fault : read.faults.list()) ADD_FAILURE() << describe(fault);
  return std::move(read.model);
}
inline Model obj_model(const std::string& text) { return obj_model({{{"a.obj", text}}}); }

inline const ModelPart& only_part(const Model& model) {
  EXPECT_EQ(model.meshes.size(), 1U);
  EXPECT_EQ(model.meshes.at(0).parts.size(), 1U);
  return model.meshes.at(0).parts.at(0);
}

/// Checks that all numbers are finite, all lists as long as they must be, all indices inside.
inline void expect_sound(const ModelPart& part, const Model& model) {
  const std::size_t vertices = part.vertices();
  EXPECT_EQ(part.positions.size(), 3 * vertices);
  for (const double x : part.positions) EXPECT_LE(std::fabs(x), 1e9);
  EXPECT_TRUE(part.normals.empty() || part.normals.size() == 3 * vertices);
  for (std::size_t i = 0; i < part.normals.size(); i += 3)
    EXPECT_GT(std::fabs(part.normals[i]) + std::fabs(part.normals[i + 1]) +
                  std::fabs(part.normals[i + 2]),
              0);
  EXPECT_TRUE(part.uvs[0].empty() || part.uvs[0].size() == 2 * vertices);
  for (const double x : part.uvs[0]) EXPECT_TRUE(std::isfinite(x));
  EXPECT_TRUE(part.colors.empty() || part.colors.size() == 4 * vertices);
  for (const float x : part.colors) EXPECT_TRUE(x >= 0 && x <= 1);
  EXPECT_EQ(part.indices.size() % 3, 0U);
  for (const std::uint32_t index : part.indices) EXPECT_LT(index, vertices);
  EXPECT_EQ(part.points, part.indices.empty());
  if (part.material) {
    EXPECT_LT(*part.material, model.materials.size());
  }
}
inline void expect_sound(const Model& model) {
  EXPECT_EQ(model.format, "obj");
  EXPECT_FALSE(model.z_up);
  EXPECT_EQ(model.nodes.size(), model.meshes.size());
  for (const ModelMesh& mesh : model.meshes) {
    EXPECT_FALSE(mesh.parts.empty());
    for (const ModelPart& part : mesh.parts) expect_sound(part, model);
  }
  for (const ModelTexture& texture : model.textures) EXPECT_LT(texture.image, model.images.size());
}

}  // namespace tia::test
