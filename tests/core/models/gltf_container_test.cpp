// Contract: GLB, JSON with files beside it and data URIs hold the same document, and what is no
// whole one is refused.
#include <gtest/gtest.h>

#include "tests/core/models/gltf_builder.h"
#include "tests/core/support.h"

namespace tia::test::gltf_files {
namespace {

std::string uri_member(const std::string& uri) { return member("uri", "\"" + uri + "\""); }

ReadGltf read_text(const std::string& json) { return read_files({{"a.gltf", to_bytes(json)}}); }
ReadGltf read_json_chunk(const std::string& json) {
  return read_glb(glb_of({glb_chunk("JSON", to_bytes(json))}));
}

TEST(GltfContainer, KnowsAFileByItsBytes) {
  const auto known = [](std::string_view text) { return is_gltf(span_of(to_bytes(text))); };
  EXPECT_TRUE(known("glTF"));
  EXPECT_TRUE(known("{\"asset\":{}}"));
  EXPECT_TRUE(known("\xEF\xBB\xBF \n\t{\"asset\":{}}"));
  EXPECT_FALSE(known(""));
  EXPECT_FALSE(known("glT"));
  EXPECT_FALSE(known("{\"objects\":[]}"));
  EXPECT_FALSE(known("[\"asset\"]"));
}

TEST(GltfContainer, TheSameDocumentInThreeWays) {
  const GltfBuilder builder = one_triangle();
  Model boxed = model_of(builder);
  EXPECT_EQ(boxed.format, "glb");
  ASSERT_EQ(boxed.meshes.size(), 1U);
  EXPECT_EQ(boxed.meshes[0].parts[0].positions, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  boxed.format = "gltf";
  for (const std::string uri : {"data:application/octet-stream;base64,", "DATA:;base64,",
                                "data:application/gltf-buffer;base64,"}) {
    const ReadGltf own = read_text(builder.json(uri_member(uri + base64(to_text(builder.bin)))));
    expect_faults(own.faults, {});
    EXPECT_TRUE(own.model == boxed);
  }
  const ReadGltf beside = read_files(
      {{"d/a.gltf", to_bytes("\xEF\xBB\xBF" + builder.json(uri_member("b%20%C3%A9/../%62.bin")))},
       {"d/b.bin", builder.bin}});
  expect_faults(beside.faults, {});
  EXPECT_TRUE(beside.model == boxed);
}

TEST(GltfContainer, ANameMayStandUnencoded) {
  const GltfBuilder builder = one_triangle();
  for (const std::string name : {"50%.bin", "a b.bin", "%41.bin"}) {
    const ReadGltf read =
        read_files({{"a.gltf", to_bytes(builder.json(uri_member(name)))}, {name, builder.bin}});
    expect_faults(read.faults, {});
  }
}

TEST(GltfContainer, AllThatDidNotComeIsToldAtOnce) {
  const ReadGltf read =
      read_text(R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"x%20y.bin"},)"
                R"({"byteLength":4,"uri":"../z.bin"},{"byteLength":4}]})");
  expect_faults(read.faults,
                {{FaultKind::missing, "/buffers/0/uri", "\"x y.bin\"", "a file of that name"},
                 {FaultKind::missing, "/buffers/1/uri", "\"../z.bin\"", "a file of that name"},
                 {FaultKind::missing, "/buffers/2/uri", "", "a data URI"}});
}

TEST(GltfContainer, OnlyWhatCameAlongIsRead) {
  for (const std::string uri : {"http://a.b/c.bin", "file:///etc/passwd", "/etc/passwd", "C:x"})
    expect_one_fault(read_text(one_triangle().json(uri_member(uri))), FaultKind::out_of_range,
                     "/buffers/0/uri");
  for (const std::string uri : {"data:,abc", "data:text/plain,abc", "data:;base64,AA=A",
                                "data:;base64,AAA", "data:;base64"})
    expect_one_fault(read_text(one_triangle().json(uri_member(uri))), FaultKind::malformed,
                     "/buffers/0/uri");
}

TEST(GltfContainer, ABufferIsAsLongAsItSays) {
  GltfBuilder builder = one_triangle();
  const std::string json = builder.json();
  Bytes longer = builder.bin;
  const auto boxed = [&](const Bytes& bin) {
    return read_glb(glb_of({glb_chunk("JSON", to_bytes(json)), glb_chunk({"BIN\0", 4}, bin)}));
  };
  longer.resize(builder.bin.size() + 2);
  expect_faults(boxed(longer).faults, {});
  EXPECT_TRUE(boxed(longer).model.warnings.empty());
  longer.resize(builder.bin.size() + 8);
  expect_faults(boxed(longer).faults, {});
  EXPECT_TRUE(boxed(longer).warned("/buffers/0"));
  longer.resize(builder.bin.size() - 4);
  expect_one_fault(boxed(longer), FaultKind::malformed, "/buffers/0");
  const auto with_length = [&](const std::string& length) {
    return read_glb(glb_of({glb_chunk("JSON", to_bytes(replaced(json, "\"byteLength\":42",
                                                                "\"byteLength\":" + length))),
                            glb_chunk({"BIN\0", 4}, builder.bin)}));
  };
  ASSERT_EQ(builder.bin.size(), 42U);
  expect_one_fault(with_length("0"), FaultKind::out_of_range, "/buffers/0/byteLength");
  expect_one_fault(with_length("1e300"), FaultKind::out_of_range, "/buffers/0/byteLength");
  expect_one_fault(with_length("\"42\""), FaultKind::wrong_type, "/buffers/0/byteLength");
  expect_one_fault(with_length("4e15"), FaultKind::malformed, "/buffers/0");
  expect_one_fault(read_json_chunk(json), FaultKind::missing, "/buffers/0/uri");
}

TEST(GltfContainer, CutAnywhereItIsRefused) {
  const Bytes file = one_triangle().glb();
  for (std::size_t size = 0; size < file.size(); ++size) {
    const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(read_glb(cut).faults.empty()) << size;
    if (size < 12) continue;
    Bytes told = cut;  // with a header that knows
    const auto words = bytes_of<std::uint32_t>({static_cast<std::uint32_t>(size)});
    std::copy(words.begin(), words.end(), told.begin() + 8);
    const std::size_t json_end = 20 + one_triangle().json().size();
    if (size < json_end) EXPECT_FALSE(read_glb(told).faults.empty()) << size;
    else read_glb(told);
  }
}

TEST(GltfContainer, OtherBoxesAreRefused) {
  const Bytes json = glb_chunk("JSON", to_bytes(R"({"asset":{"version":"2.0"}})"));
  const Bytes bin = glb_chunk({"BIN\0", 4}, {1, 2, 3, 4}), other = glb_chunk("WHAT", {1});
  expect_faults(read_glb(glb_of({json})).faults, {});
  expect_faults(read_glb(glb_of({json, bin})).faults, {});
  expect_faults(read_glb(glb_of({json, bin, other, other})).faults, {});
  expect_faults(read_glb(glb_of({json, other})).faults, {});
  for (const Bytes& file :
       {glb_of({json}, 1), glb_of({json}, 3), glb_of({bin, json}), glb_of({other, json}),
        glb_of({json, json}), glb_of({json, bin, bin}), glb_of({json, other, bin}), glb_of({})})
    expect_one_fault(read_glb(file), FaultKind::malformed, "");
  Bytes longer = glb_of({json});
  longer.push_back(7);
  expect_faults(read_glb(longer).faults, {});
  EXPECT_TRUE(read_glb(longer).warned(""));
  Bytes unaligned = glb_of({json, other});
  unaligned[12 + json.size()] = 3;
  expect_one_fault(read_glb(unaligned), FaultKind::malformed, "");
}

TEST(GltfContainer, OfVersionTwoOnly) {
  const auto asset = [](const std::string& text) { return read_text("{\"asset\":" + text + "}"); };
  for (const auto text :
       {R"({"version":"2.0"})", R"({"version":"2.1"})", R"({"version":"2.1","minVersion":"2.0"})"})
    expect_faults(asset(text).faults, {});
  const std::vector<std::pair<std::string, FaultKind>> wrong{
      {R"({"version":"1.0"})", FaultKind::out_of_range},
      {R"({"version":"3.0"})", FaultKind::out_of_range},
      {R"({"version":"2"})", FaultKind::out_of_range},
      {R"({"version":"2.x"})", FaultKind::out_of_range},
      {R"({"version":"-2.0"})", FaultKind::out_of_range},
      {R"({"version":2.0})", FaultKind::wrong_type},
      {R"({"generator":"x"})", FaultKind::missing}};
  for (const auto& row : wrong) expect_one_fault(asset(row.first), row.second, "/asset/version");
  expect_one_fault(asset(R"({"version":"2.1","minVersion":"2.1"})"), FaultKind::out_of_range,
                   "/asset/minVersion");
  expect_one_fault(read_text(R"({"nodes":[]})"), FaultKind::missing, "/asset");
  expect_one_fault(read_text("[]"), FaultKind::wrong_type, "");
  const ReadGltf named = asset(R"({"version":"2.0","generator":"g","copyright":"c"})");
  EXPECT_EQ(named.model.generator, "g");
  EXPECT_EQ(named.model.copyright, "c");
}

TEST(GltfContainer, ExtensionsAreTakenToldOfOrRefused) {
  const auto with = [](const std::string& lists) {
    return read_text(R"({"asset":{"version":"2.0"},)" + lists + "}");
  };
  const ReadGltf used = with(R"("extensionsUsed":["KHR_materials_unlit","VENDOR_thing"])");
  expect_faults(used.faults, {});
  EXPECT_EQ(used.model.extensions,
            (std::vector<std::string>{"KHR_materials_unlit", "VENDOR_thing"}));
  EXPECT_FALSE(used.warned("/extensionsUsed/0"));
  EXPECT_TRUE(used.warned("/extensionsUsed/1"));
  expect_faults(with(R"("extensionsRequired":["KHR_mesh_quantization"])").faults, {});
  const ReadGltf refused =
      with(R"("extensionsRequired":["KHR_mesh_quantization","KHR_material_unlit"])");
  expect_faults(refused.faults,
                {{FaultKind::unknown_name, "/extensionsRequired/1", "\"KHR_material_unlit\"",
                  "KHR_lights_punctual", "KHR_materials_unlit"}});
  expect_one_fault(with(R"("extensionsUsed":["A","B","A"])"), FaultKind::conflict,
                   "/extensionsUsed/2");
  expect_one_fault(with(R"("extensionsUsed":[5])"), FaultKind::wrong_type, "/extensionsUsed/0");
}

TEST(GltfContainer, BrokenTextIsAFaultAtItsPlace) {
  expect_one_fault(read_text(R"({"asset":{"version":"2.0"},"nodes":[{"a":1,"a":2}]})"),
                   FaultKind::malformed, "/nodes/0/a");
  expect_one_fault(read_text(R"({"asset":{"version":"2.0"},"nodes":[)"), FaultKind::malformed,
                   "/nodes/0");
  std::string deep = R"({"asset":{"version":"2.0"},"extras":)";
  for (int i = 0; i < 100'000; ++i) deep += '[';
  const ReadGltf read = read_text(deep);
  ASSERT_EQ(read.faults.size(), 1U);
  EXPECT_EQ(read.faults[0].kind, FaultKind::malformed);
  ModelLimits few;
  few.json_values = 10;
  expect_one_fault(read_files({{"a", to_bytes(R"({"asset":{"version":"2.0"},"nodes":[{},{},)"
                                              R"({},{},{},{},{},{},{},{}]})")}},
                              few),
                   FaultKind::limit, "/nodes/6");
}

// Any byte of it may be another: then it is another model, or refused.
TEST(GltfContainer, ChangedAnywhereItIsRefusedOrWhole) {
  Random random(20'240'607);
  const Bytes file = one_triangle().glb();
  for (int round = 0; round < rounds(4000); ++round) {
    Bytes changed = file;
    for (int changes = random.whole(1, 3); changes > 0; --changes) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(file.size())));
      changed[at] = static_cast<std::uint8_t>(random.below(256));
    }
    const ReadGltf read = read_glb(changed);
    if (!read.faults.empty()) continue;
    for (const ModelMesh& mesh : read.model.meshes)
      for (const ModelPart& part : mesh.parts)
        for (const std::uint32_t index : part.indices) ASSERT_LT(index, part.vertices());
  }
}

}  // namespace
}  // namespace tia::test::gltf_files
