// One file through a reader of models, and what every model that comes out of one must be.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"
#include "tests/core/support.h"

namespace tia::test {

/// ReadModel: what a reader made of a file.
struct ReadModel {
  Model model;
  std::vector<Fault> faults;

  const ModelPart& part(std::size_t mesh = 0) const { return model.meshes.at(mesh).parts.at(0); }
  const Fault& fault() const { return faults.at(0); }
};

inline ModelBytes model_bytes(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

using ModelReader = void(const ModelFiles&, const ModelLimits&, Faults&, Model&);

inline ReadModel read_model_file(ModelReader read, std::string_view file,
                                 const ModelLimits& limits = {}) {
  Faults faults;
  ReadModel out;
  read(ModelFiles{{{"folder/model", model_bytes(file)}}, 0}, limits, faults, out.model);
  out.faults = faults.list();
  return out;
}

/// The bytes of a number, lowest first.
template <class Number>
std::string bytes_of_number(Number number) {
  std::uint64_t bits = 0;
  if constexpr (sizeof(Number) == 8) bits = std::bit_cast<std::uint64_t>(number);
  else if constexpr (std::is_same_v<Number, float>) bits = std::bit_cast<std::uint32_t>(number);
  else bits = static_cast<std::make_unsigned_t<Number>>(number);
  std::string bytes;
  for (std::size_t i = 0; i < sizeof number; ++i)
    bytes += static_cast<char>(static_cast<std::uint8_t>(bits >> (8 * i)));
  return bytes;
}

/// A part whose lists fit each other, whose indices are there and whose numbers are finite.
inline void expect_sound_part(const ModelPart& part) {
  const std::size_t vertices = part.vertices();
  EXPECT_EQ(part.positions.size(), 3 * vertices);
  EXPECT_TRUE(part.normals.empty() || part.normals.size() == 3 * vertices);
  EXPECT_TRUE(part.uvs[0].empty() || part.uvs[0].size() == 2 * vertices);
  EXPECT_TRUE(part.colors.empty() || part.colors.size() == 4 * vertices);
  EXPECT_EQ(part.indices.size() % 3, 0U);
  for (const std::uint32_t index : part.indices) EXPECT_LT(index, vertices);
  for (const double x : part.positions) EXPECT_LE(std::fabs(x), 1e9);
  for (const float x : part.normals) EXPECT_TRUE(std::isfinite(x));
  for (const double x : part.uvs[0]) EXPECT_TRUE(std::isfinite(x));
  for (const float x : part.colors) EXPECT_TRUE(x >= 0 && x <= 1) << x;
}

/// Either faults, each in words, or a sound model.
inline void expect_sound_model(const ReadModel& read) {
  for (const Fault& fault : read.faults) EXPECT_FALSE(fault.allowed.empty());
  if (!read.faults.empty()) return;
  for (const ModelMesh& mesh : read.model.meshes)
    for (const ModelPart& part : mesh.parts) expect_sound_part(part);
}

/// The file, of which some bytes are others.
inline std::string damaged_file(std::string file, Random& random) {
  for (int i = random.whole(1, 4); i > 0; --i) {
    const auto at = static_cast<std::size_t>(random.below(static_cast<int>(file.size())));
    file[at] = static_cast<char>(random.chance(0.5) ? random.below(256) : random.whole(' ', '9'));
  }
  return file;
}

}  // namespace tia::test
