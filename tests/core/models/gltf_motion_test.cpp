// Contract: skins have a matrix for each joint, and animations a value for each time.
#include <gtest/gtest.h>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

std::string number(int n) { return std::to_string(n); }

// A matrix whose numbers are all others, affine.
std::vector<float> matrix_from(float first) {
  std::vector<float> matrix(16);
  for (std::size_t i = 0; i < 16; ++i)
    matrix[i] = i % 4 == 3 ? (i == 15 ? 1.0F : 0.0F) : first + static_cast<float>(i);
  return matrix;
}
std::vector<float> joined(std::vector<float> a, const std::vector<float>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Node 0 wears skin 0 with the joints 1 and 2; its one point names the joint `joint`.
GltfBuilder skinned(const std::string& skin, const std::vector<float>& matrices = {},
                    std::uint8_t joint = 1, float weight = 0.5) {
  GltfBuilder builder;
  const int positions = builder.vec3({0, 0, 0}),
            joints = builder.numbers<std::uint8_t>(gltf_ubyte, "VEC4", 4, {0, joint, 0, 0}),
            weights = builder.floats("VEC4", 4, {weight, 0.5, 0, 0});
  builder.floats("MAT4", 16,
                 matrices.empty() ? joined(matrix_from(1), matrix_from(100)) : matrices);
  builder.set("meshes", one_primitive("\"POSITION\":" + number(positions) + ",\"JOINTS_0\":" +
                                          number(joints) + ",\"WEIGHTS_0\":" + number(weights),
                                      ",\"mode\":0"));
  builder.set("nodes", R"([{"mesh":0,"skin":0},{"children":[2]},{}])");
  builder.set("skins", "[{" + skin + "}]");
  return builder;
}

TEST(GltfMotion, SkinsHaveAMatrixForEachJoint) {
  const Model model =
      model_of(skinned(R"("name":"s","joints":[2,1],"inverseBindMatrices":3,"skeleton":1)"));
  ASSERT_EQ(model.skins.size(), 1U);
  EXPECT_EQ(model.skins[0].name, "s");
  EXPECT_EQ(model.skins[0].joints, (std::vector<ModelIndex>{2, 1}));
  ASSERT_EQ(model.skins[0].inverse_binds.size(), 2U);
  EXPECT_EQ(model.skins[0].inverse_binds[0],
            (std::array<double, 16>{1, 2, 3, 0, 5, 6, 7, 0, 9, 10, 11, 0, 13, 14, 15, 1}));
  EXPECT_EQ(model.skins[0].inverse_binds[1][4], 104);
  const Model plain = model_of(skinned(R"("joints":[1,2])"));
  EXPECT_EQ(
      plain.skins[0].inverse_binds,
      (std::vector<std::array<double, 16>>(2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1})));
}

TEST(GltfMotion, SkinsThatDoNotFitAreRefused) {
  const auto refused = [](const GltfBuilder& builder, FaultKind kind, const std::string& at) {
    expect_one_fault(read_built(builder), kind, at);
  };
  const auto conflict = FaultKind::conflict, beyond = FaultKind::out_of_range;
  refused(skinned(R"("joints":[1,1])"), conflict, "/skins/0/joints/1");
  refused(skinned(R"("joints":[1,3])"), beyond, "/skins/0/joints/1");
  refused(skinned(R"("joints":[1,2],"skeleton":3)"), beyond, "/skins/0/skeleton");
  refused(skinned(R"("name":"a")"), FaultKind::missing, "/skins/0/joints");
  const std::string both = R"("joints":[1,2],"inverseBindMatrices":)",
                    at = "/skins/0/inverseBindMatrices";
  refused(skinned(both + "3", matrix_from(1)), conflict, at);
  refused(skinned(both + "2"), FaultKind::wrong_type, at);
  std::vector<float> projective = joined(matrix_from(1), matrix_from(2));
  projective[19] = 0.5;
  refused(skinned(both + "3", projective), beyond, at);
  // The joint that a vertex names.
  refused(skinned(R"("joints":[1,2])", {}, 2), beyond, "/nodes/0/skin");
  refused(skinned(R"("joints":[1])"), beyond, "/nodes/0/skin");
  GltfBuilder stiff = one_triangle();
  stiff.members = replaced(stiff.members, "{\"mesh\":0}", "{\"mesh\":0,\"skin\":0}");
  stiff.set("skins", "[{\"joints\":[0]}]");
  refused(stiff, conflict, "/nodes/0");
  GltfBuilder bare = skinned(R"("joints":[1,2])");
  bare.members = replaced(bare.members, "{\"children\":[2]}", "{\"children\":[2],\"skin\":0}");
  refused(bare, conflict, "/nodes/1/skin");
}

// Accessors: 0 positions, 1 times 0 1 2.5, 2 three vectors, 3 three quaternions, 4 six numbers,
// 5 nine vectors, 6 quaternions of shorts, 7 times that stand still, 8 times below 0, 9 six bytes,
// 10 three quaternions, one of them zero.
GltfBuilder animated(const std::string& samplers, const std::string& channels) {
  GltfBuilder builder;
  builder.vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  builder.floats("SCALAR", 1, {0, 1, 2.5});
  builder.vec3({1, 2, 3, 4, 5, 6, 7, 8, 9});
  builder.floats("VEC4", 4, {0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 2, 0});
  builder.floats("SCALAR", 1, {0, 1, 2, 3, 4, 5});
  builder.vec3(std::vector<float>(27, 3.0F));
  builder.numbers<std::int16_t>(gltf_short, "VEC4", 4,
                                {0, 0, 0, 32767, -32768, 0, 0, 0, 0, 32767, 0, 0},
                                ",\"normalized\":true");
  builder.floats("SCALAR", 1, {0, 1, 1});
  builder.floats("SCALAR", 1, {-1, 0, 1});
  builder.numbers<std::uint8_t>(gltf_ubyte, "SCALAR", 1, {0, 51, 102, 153, 204, 255},
                                ",\"normalized\":true");
  builder.floats("VEC4", 4, {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 2, 0});
  builder.set("meshes",
              one_primitive("\"POSITION\":0", R"(,"targets":[{"POSITION":0},{"POSITION":0}])"));
  builder.set("nodes", R"([{"mesh":0},{},{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}])");
  builder.set("animations",
              "[{\"name\":\"a\",\"samplers\":[" + samplers + "],\"channels\":[" + channels + "]}]");
  return builder;
}
std::string sampler(int input, int output, const std::string& more = "") {
  return "{\"input\":" + number(input) + ",\"output\":" + number(output) + more + "}";
}
std::string channel(int sampler, int node, const std::string& path) {
  return "{\"sampler\":" + number(sampler) + ",\"target\":{\"node\":" + number(node) +
         ",\"path\":\"" + path + "\"}}";
}
AnimationChannel channel_of(const std::string& sampler, int node, const std::string& path) {
  const Model model = model_of(animated(sampler, channel(0, node, path)));
  const bool has = !model.animations.empty() && !model.animations[0].channels.empty();
  EXPECT_TRUE(has);
  return has ? model.animations[0].channels[0] : AnimationChannel{};
}

TEST(GltfMotion, ChannelsHaveTheirSamplersNumbers) {
  const std::vector<float> times{0, 1, 2.5};
  EXPECT_EQ(channel_of(sampler(1, 2), 1, "translation"),
            (AnimationChannel{1,
                              AnimatedPath::translation,
                              Interpolation::linear,
                              times,
                              {1, 2, 3, 4, 5, 6, 7, 8, 9}}));
  EXPECT_EQ(channel_of(sampler(1, 2, R"(,"interpolation":"STEP")"), 0, "scale"),
            (AnimationChannel{
                0, AnimatedPath::scale, Interpolation::step, times, {1, 2, 3, 4, 5, 6, 7, 8, 9}}));
  EXPECT_EQ(channel_of(sampler(1, 3), 1, "rotation").values,
            (std::vector<float>{0, 0, 0, 1, 1, 0, 0, 0, 0, 0, 2, 0}));
  EXPECT_EQ(channel_of(sampler(1, 6), 1, "rotation").values,
            (std::vector<float>{0, 0, 0, 1, -1, 0, 0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(channel_of(sampler(1, 4), 0, "weights").values, (std::vector<float>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(channel_of(sampler(1, 9), 0, "weights").values,
            (std::vector<float>{0, 0.2F, 0.4F, 0.6F, 0.8F, 1}));
  const AnimationChannel spline =
      channel_of(sampler(1, 5, R"(,"interpolation":"CUBICSPLINE")"), 1, "scale");
  EXPECT_EQ(spline.interpolation, Interpolation::cubic_spline);
  EXPECT_EQ(spline.values, std::vector<float>(27, 3.0F));
}

TEST(GltfMotion, ChannelsOfNothingArePassedOver) {
  const ReadGltf read = read_built(
      animated(sampler(1, 2), R"({"sampler":0,"target":{"path":"translation"}},)" +
                                  channel(0, 1, "pointer") + "," + channel(0, 1, "translation")));
  expect_faults(read.faults, {});
  EXPECT_EQ(read.model.animations[0].name, "a");
  EXPECT_EQ(read.model.animations[0].channels.size(), 1U);
  EXPECT_TRUE(read.warned("/animations/0/channels/1/target/path"));
}

TEST(GltfMotion, ChannelsThatDoNotFitAreRefused) {
  const auto refused = [](const std::string& samplers, const std::string& channels, FaultKind kind,
                          const std::string& at) {
    expect_one_fault(read_built(animated(samplers, channels)), kind, "/animations/0/" + at);
  };
  const auto conflict = FaultKind::conflict, beyond = FaultKind::out_of_range,
             type = FaultKind::wrong_type;
  const std::string move = channel(0, 1, "translation"), at = "channels/0/sampler";
  refused(sampler(1, 4), move, type, at);
  refused(sampler(1, 6), move, type, at);
  refused(sampler(1, 5), move, conflict, at);
  refused(sampler(1, 4), channel(0, 1, "weights"), conflict, "channels/0/target");
  refused(sampler(1, 1), channel(0, 0, "weights"), conflict, at);
  refused(sampler(1, 10), channel(0, 1, "rotation"), beyond, at);
  refused(sampler(1, 2), channel(0, 2, "translation"), conflict, "channels/0/target");
  refused(sampler(1, 2), channel(1, 1, "translation"), beyond, at);
  refused(sampler(1, 2), channel(0, 3, "translation"), beyond, "channels/0/target/node");
  refused(sampler(1, 2), move + "," + move, conflict, "channels/1/target");
  refused(sampler(1, 2, R"(,"interpolation":"CUBICSPLINE")"), move, conflict, at);
  refused(sampler(1, 2, R"(,"interpolation":"linear")"), move, beyond, "samplers/0/interpolation");
  refused(sampler(7, 2), move + "," + channel(0, 0, "translation"), beyond, "samplers/0/input");
  refused(sampler(8, 2), move, beyond, "samplers/0/input");
  refused(sampler(2, 2), move, type, "samplers/0/input");
  refused(sampler(99, 2), move, beyond, "samplers/0/input");
  refused("{\"input\":1}", move, FaultKind::missing, "samplers/0/output");
  refused(sampler(1, 2), R"({"sampler":0})", FaultKind::missing, "channels/0/target");
  refused(sampler(1, 2), R"({"target":{"node":1,"path":"scale"}})", FaultKind::missing, at);
  refused(sampler(1, 2), "", beyond, "channels");
}

// What check_model() would not take of the reader's answer.
TEST(GltfMotion, NumbersTooLargeForAModelAreRefused) {
  const auto refused = [](const GltfBuilder& builder, const std::string& at) {
    expect_one_fault(read_built(builder), FaultKind::out_of_range, at);
  };
  const std::string move = channel(0, 1, "translation");
  GltfBuilder far = animated(sampler(1, 11), move), late = animated(sampler(11, 2), move);
  far.floats("VEC3", 3, {1, 2, 3, 4, 2e9F, 6, 7, 8, 9});
  refused(far, "/accessors/11");
  late.floats("SCALAR", 1, {0, 1, 2e9F});
  refused(late, "/accessors/11");
  refused(skinned(R"("joints":[1,2],"inverseBindMatrices":3)",
                  joined(matrix_from(1), matrix_from(2e9F))),
          "/accessors/3");
  refused(skinned(R"("joints":[1,2])", {}, 1, 2e6F), "/meshes/0/primitives/0/attributes/WEIGHTS_0");
}

// Many channels may share what one sampler has: each counts.
TEST(GltfMotion, TheirNumbersHaveALimit) {
  const GltfBuilder builder =
      animated(sampler(1, 2), channel(0, 0, "translation") + "," + channel(0, 1, "translation"));
  ModelLimits limits;
  limits.vertices = 24;
  expect_faults(read_built(builder, limits).faults, {});
  limits.vertices = 23;
  expect_one_fault(read_built(builder, limits), FaultKind::limit, "/animations/0/channels/1");
}

// Any number of the text may be another.
TEST(GltfMotion, ChangedAnywhereItIsRefusedOrWhole) {
  Random random(5);
  const Bytes file = animated(sampler(1, 2), channel(0, 1, "translation")).glb(),
              other = skinned(R"("joints":[1,2],"inverseBindMatrices":3)").glb();
  for (int round = 0; round < rounds(3000); ++round) {
    Bytes changed = round % 2 == 0 ? file : other;
    for (int changes = random.whole(1, 3); changes > 0; --changes) {
      std::uint8_t& byte = changed[20 + static_cast<std::size_t>(
                                            random.below(static_cast<int>(changed.size() - 20)))];
      if (byte >= '0' && byte <= '9') byte = static_cast<std::uint8_t>(random.whole('0', '9'));
      else if (random.chance(0.2)) byte = static_cast<std::uint8_t>(random.below(256));
    }
    const ReadGltf read = read_glb(changed);
    if (!read.faults.empty()) continue;
    for (const ModelSkin& skin : read.model.skins)
      ASSERT_EQ(skin.joints.size(), skin.inverse_binds.size());
    for (const ModelAnimation& animation : read.model.animations)
      for (const AnimationChannel& each : animation.channels)
        ASSERT_EQ(each.values.size() % each.times.size(), 0U);
  }
}

}  // namespace
}  // namespace tia::test::gltf_files
