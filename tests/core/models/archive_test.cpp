// A flat form goes from process to process, and is looked at as a stranger's.
#include "core/models/archive.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/models/byte_source.h"
#include "core/models/check_model.h"
#include "tests/core/models/random_model.h"

namespace tia::test {
namespace {

std::vector<std::uint8_t> archive_of(const Model& model) {
  std::vector<std::uint8_t> bytes;
  write_archive(model,
                [&](ModelBytes piece) { bytes.insert(bytes.end(), piece.begin(), piece.end()); });
  EXPECT_EQ(bytes.size(), archive_size(model));
  return bytes;
}
std::size_t faults_of(const Model& model, const ModelLimits& limits = {}) {
  Faults faults;
  check_model(model, limits, faults);
  return faults.count();
}

TEST(ModelArchive, GivesBackWhatItTook) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const Model model = random_model(random);
    ASSERT_EQ(faults_of(model), 0U) << i;
    const auto back = unarchived(archive_of(model));
    ASSERT_TRUE(back.has_value()) << i;
    EXPECT_EQ(*back, model) << i;
  }
}

TEST(ModelArchive, OfAnyOtherLengthIsNone) {
  Random random(8);
  const std::vector<std::uint8_t> bytes = archive_of(random_model(random));
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 64)
    EXPECT_FALSE(unarchived({bytes.data(), n}).has_value()) << n;
  std::vector<std::uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(unarchived(longer).has_value());
}

// Whatever a byte is changed to: none, or what check_model can judge.
TEST(ModelArchive, OfChangedBytesIsNoneOrCanBeChecked) {
  Random random(9);
  const std::vector<std::uint8_t> bytes = archive_of(random_model(random));
  int some = 0, faulty = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<std::uint8_t> changed = bytes;
    for (int k = random.whole(1, 3); k > 0; --k)
      changed[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))] =
          static_cast<std::uint8_t>(random.below(256));
    const auto model = unarchived(changed);
    if (!model) continue;
    ++some;
    faulty += faults_of(*model) > 0 ? 1 : 0;
  }
  EXPECT_GT(some, 100);
  EXPECT_GT(faulty, 10);
}

/// Bytes that come a few at a time.
class Dribble : public ByteSource {
 public:
  explicit Dribble(ModelBytes bytes) : all_(bytes) {}
  std::size_t read(std::span<std::uint8_t> room) override {
    return all_.read(room.first(std::min(room.size(), 1 + calls_++ % 5000)));
  }
  std::uint64_t most() const override { return all_.most(); }

 private:
  BytesInMemory all_;
  std::size_t calls_ = 0;
};

TEST(ModelArchive, MayComePieceByPiece) {
  Random random(10);
  Model model = random_model(random);
  model.copyright.assign(1'000'000, 'c');  // longer than what a list takes at once
  const std::vector<std::uint8_t> bytes = archive_of(model);
  Dribble whole(bytes), cut(ModelBytes(bytes).first(bytes.size() - 1)), more(bytes);
  EXPECT_EQ(unarchived(whole, bytes.size()), model);
  EXPECT_FALSE(unarchived(cut, bytes.size()).has_value());
  EXPECT_FALSE(unarchived(more, bytes.size() - 1).has_value());
}

// ---- check_model
// ---------------------------------------------------------------------------------

// A change that makes a sound model unsound, and where it is told.
struct Spoil {
  const char* pointer;
  void (*change)(Model&);
};

class CheckModel : public testing::TestWithParam<Spoil> {};

TEST_P(CheckModel, TellsWhere) {
  Model model = full_model();
  ASSERT_EQ(faults_of(model), 0U);
  GetParam().change(model);
  Faults faults;
  check_model(model, {}, faults);
  ASSERT_GT(faults.count(), 0U);
  EXPECT_THAT(faults.list().front().pointer, testing::StartsWith(GetParam().pointer));
}

INSTANTIATE_TEST_SUITE_P(
    All, CheckModel,
    testing::Values(
        Spoil{"/scenes", [](Model& m) { m.scenes.clear(); }},
        Spoil{"/scene", [](Model& m) { m.scene = 9; }},
        Spoil{"/scenes/0/nodes/0", [](Model& m) { m.scenes[0].nodes[0] = 77; }},
        Spoil{"/scenes/0/nodes/0", [](Model& m) { m.scenes[0].nodes[0] = 1; }},
        Spoil{"/nodes/0/children/0", [](Model& m) { m.nodes[0].children[0] = 99; }},
        Spoil{"/nodes/1/children/0",
              [](Model& m) {
                m.nodes[1].children = {1, 1};
              }},
        Spoil{"/nodes/0", [](Model& m) { m.nodes[1].children = {0}; }},
        Spoil{"/nodes/0/mesh", [](Model& m) { m.nodes[0].mesh = 5; }},
        Spoil{"/nodes/0/skin", [](Model& m) { m.nodes[0].skin = 5; }},
        Spoil{"/nodes/0/camera", [](Model& m) { m.nodes[0].camera = 5; }},
        Spoil{"/nodes/0/light", [](Model& m) { m.nodes[0].light = 5; }},
        Spoil{"/nodes/0/rotation", [](Model& m) { m.nodes[0].placement.rotation = {}; }},
        Spoil{"/nodes/0/matrix", [](Model& m) { m.nodes[0].matrix.emplace()[3] = 2e9; }},
        Spoil{"/nodes/0/skin", [](Model& m) { m.meshes[0].parts[0].joints[3] = 2; }},
        Spoil{"/meshes/0/parts/0/positions",
              [](Model& m) { m.meshes[0].parts[0].positions[1] = 1e10; }},
        Spoil{"/meshes/0/parts/0/positions",
              [](Model& m) { m.meshes[0].parts[0].positions.push_back(1); }},
        Spoil{"/meshes/0/parts/0/normals",
              [](Model& m) { std::ranges::fill(m.meshes[0].parts[0].normals, 0.0F); }},
        Spoil{"/meshes/0/parts/0", [](Model& m) { m.meshes[0].parts[0].uvs[1].pop_back(); }},
        Spoil{"/meshes/0/parts/0/indices", [](Model& m) { m.meshes[0].parts[0].indices[0] = 9; }},
        Spoil{"/meshes/0/parts/0/indices", [](Model& m) { m.meshes[0].parts[0].points = true; }},
        Spoil{"/meshes/0/parts/0/weights", [](Model& m) { m.meshes[0].parts[0].weights[0] = -1; }},
        Spoil{"/meshes/0/parts/0/targets",
              [](Model& m) { m.meshes[0].parts[0].targets[0].positions.pop_back(); }},
        Spoil{"/meshes/0/parts/0/material", [](Model& m) { m.meshes[0].parts[0].material = 3; }},
        Spoil{"/meshes/0/weights",
              [](Model& m) {
                m.meshes[0].weights = {1, 2, 3};
              }},
        Spoil{"/materials/0", [](Model& m) { m.materials[0].roughness = 1.5; }},
        Spoil{"/materials/0", [](Model& m) { m.materials[0].base_color.g = NAN; }},
        Spoil{"/materials/0/texture",
              [](Model& m) { m.materials[0].base_color_texture->texture = 4; }},
        Spoil{"/textures/0/image", [](Model& m) { m.textures[0].image = 4; }},
        Spoil{"/cameras/0/yfov", [](Model& m) { m.cameras[0].yfov = 4; }},
        Spoil{"/lights/0", [](Model& m) { m.lights[0].intensity = -1; }},
        Spoil{"/skins/0/joints/0", [](Model& m) { m.skins[0].joints[0] = 50; }},
        Spoil{"/skins/0/inverse_binds", [](Model& m) { m.skins[0].inverse_binds.pop_back(); }},
        Spoil{"/animations/0/channels/0/node",
              [](Model& m) { m.animations[0].channels[0].node = 50; }},
        Spoil{"/animations/0/channels/0/times",
              [](Model& m) { m.animations[0].channels[0].times[1] = 0; }},
        Spoil{"/animations/0/channels/0/values",
              [](Model& m) { m.animations[0].channels[0].values.pop_back(); }}));

TEST(CheckModelLimits, AreRefusedOneBeyond) {
  const Model model = full_model();
  const ModelLimits exact{.triangles = 2, .vertices = 4, .nodes = 2, .depth = 2, .instances = 1};
  EXPECT_EQ(faults_of(model, exact), 0U);
  for (const auto limit : {&ModelLimits::triangles, &ModelLimits::vertices, &ModelLimits::nodes,
                           &ModelLimits::depth, &ModelLimits::instances}) {
    ModelLimits less = exact;
    --(less.*limit);
    EXPECT_GT(faults_of(model, less), 0U);
  }
}

// A chain of nodes as long as the file likes takes no stack and no time.
TEST(CheckModelLimits, RefuseALongChainQuickly) {
  Model model = full_model();
  model.nodes.resize(60'000);
  for (ModelIndex i = 1; i + 1 < model.nodes.size(); ++i) model.nodes[i].children = {i + 1};
  Faults faults;
  check_model(model, {}, faults);
  ASSERT_GT(faults.count(), 0U);
  EXPECT_EQ(faults.list().front().kind, FaultKind::limit);
}

}  // namespace
}  // namespace tia::test
