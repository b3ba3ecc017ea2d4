// The same triangles give the same picture, byte for byte, whether a scene or a file of any format
// has them.
#include <gtest/gtest.h>

#include <sstream>

#include "core/accel/world/world.h"
#include "core/film/pfm.h"
#include "tests/core/models/gltf_builder.h"
#include "tests/core/models/obj_files.h"
#include "tests/core/models/ply_files.h"
#include "tests/core/models/stl_files.h"
#include "tests/core/scene/models.h"

namespace tia::test {
namespace {

// FileTriangles: triangles of three vertices each, of floats, as all formats have them.
struct FileTriangles {
  std::vector<float> positions, normals;
  std::size_t vertices() const { return positions.size() / 3; }
};
FileTriangles random_triangles(std::uint64_t seed) {
  Random random(seed);
  FileTriangles made;
  for (int i = 0; i < 24; ++i) {
    const Vec3d middle = random.point(2), facing = random.direction();
    for (int k = 0; k < 3; ++k) {
      const Vec3d p = middle + random.direction(), n = facing + random.point(0.3);
      for (const double x : {p.x, p.y, p.z}) made.positions.push_back(static_cast<float>(x));
      for (const double x : {n.x, n.y, n.z}) made.normals.push_back(static_cast<float>(x));
    }
  }
  return made;
}
std::vector<std::uint32_t> counted_up(std::size_t n) {
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < n; ++i) indices.push_back(i);
  return indices;
}

// ---- the files ----------------------------------------------------------------------------------

Model glb_of_triangles(const FileTriangles& from, bool smooth) {
  gltf_files::GltfBuilder builder;
  std::string attributes = gltf_files::named("POSITION", builder.vec3(from.positions));
  if (smooth) attributes += "," + gltf_files::named("NORMAL", builder.vec3(from.normals));
  const int indices = builder.numbers<std::uint32_t>(gltf_files::gltf_uint, "SCALAR", 1,
                                                     counted_up(from.vertices()));
  builder.set("meshes", gltf_files::one_primitive(
                            attributes, gltf_files::member("indices", std::to_string(indices))));
  builder.set("nodes", R"([{"mesh":0}])");
  builder.set("scenes", R"([{"nodes":[0]}])");
  return gltf_files::model_of(builder);
}

Model obj_of_triangles(const FileTriangles& from, bool smooth) {
  std::ostringstream text;
  text.precision(17);
  for (std::size_t i = 0; i < from.positions.size(); i += 3) {
    const float* p = &from.positions[i];
    const float* n = &from.normals[i];
    text << "v " << p[0] << " " << p[1] << " " << p[2] << "\n";
    if (smooth) text << "vn " << n[0] << " " << n[1] << " " << n[2] << "\n";
  }
  for (std::size_t i = 1; i <= from.vertices(); i += 3) {
    text << "f";
    for (std::size_t k = i; k < i + 3; ++k) {
      text << " " << k;
      if (smooth) text << "//" << k;
    }
    text << "\n";
  }
  return obj_model(text.str());
}

Model ply_of_triangles(const FileTriangles& from, bool smooth, std::string_view encoding) {
  PlyFile file = ply_vertices(from.vertices());
  for (const char* name : {"nx", "ny", "nz"})
    if (smooth) file.property("float", name);
  file.element("face", from.vertices() / 3).list("uchar", "int", "vertex_indices");
  for (std::size_t i = 0; i < from.positions.size(); i += 3) {
    for (std::size_t k = i; k < i + 3; ++k) file.put("float", double{from.positions[k]});
    for (std::size_t k = i; k < i + 3 && smooth; ++k) file.put("float", double{from.normals[k]});
    file.end_row();
  }
  for (int i = 0; i < static_cast<int>(from.vertices()); i += 3)
    file.put_list("uchar", "int", {i, i + 1, i + 2}).end_row();
  const ReadModel read = read_ply_file(file.in(encoding));
  expect_faults(read.faults, {});
  return read.model;
}

Model stl_of_triangles(const FileTriangles& from, bool text) {
  std::vector<StlTriangle> triangles(from.vertices() / 3);
  for (std::size_t i = 0; i < from.positions.size(); ++i)
    triangles[i / 9][i % 9] = from.positions[i];
  const ReadModel read = read_stl_file(text ? stl_text(triangles, "it") : stl_bytes(triangles));
  expect_faults(read.faults, {});
  return read.model;
}

// ---- the pictures -------------------------------------------------------------------------------

Scene lit_scene(Object object) {
  Scene scene;
  scene.camera.location = {1, 2, 9};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.background = {0.2, 0.3, 0.4};
  scene.lights = {point_light({5, 9, 8}), sphere_light({-6, 7, 3}, 1)};
  object.material = MaterialRef(matte({0.7, 0.6, 0.2}));
  scene.objects = {std::move(object)};
  return scene;
}
std::string pfm_of(const Scene& scene) { return encode_pfm(picture(scene, 64, 48).image); }

std::string pfm_of_mesh(const FileTriangles& from, bool smooth, const TransformSteps& place = {}) {
  Mesh mesh;
  mesh.positions.values.assign(from.positions.begin(), from.positions.end());
  if (smooth) mesh.normals.values.assign(from.normals.begin(), from.normals.end());
  mesh.indices.values = counted_up(from.vertices());
  return pfm_of(lit_scene({"", mesh, place, {}}));
}
std::string pfm_of_model(const Model& model, const std::string& members = R"("up":"y")") {
  return pfm_of(resolved(lit_scene(read_scene(model_scene(members)).objects[0]), model));
}

TEST(ModelFormats, GiveThePictureOfTheSameMeshByteForByte) {
  for (const bool smooth : {false, true}) {
    const FileTriangles triangles = random_triangles(2200 + (smooth ? 1 : 0));
    const std::string expected = pfm_of_mesh(triangles, smooth);
    EXPECT_TRUE(pfm_of_model(glb_of_triangles(triangles, smooth)) == expected) << smooth;
    EXPECT_TRUE(pfm_of_model(obj_of_triangles(triangles, smooth)) == expected) << smooth;
    for (const std::string_view encoding : ply_encodings)
      EXPECT_TRUE(pfm_of_model(ply_of_triangles(triangles, smooth, encoding)) == expected)
          << smooth << encoding;
    if (smooth) continue;
    for (const bool text : {false, true})
      EXPECT_TRUE(pfm_of_model(stl_of_triangles(triangles, text)) == expected) << text;
  }
}

// (x, y, z) to (x, z, -y), as a matrix.
TEST(ModelFormats, OfStlAndPlyZPointsUp) {
  const FileTriangles triangles = random_triangles(2203);
  const TransformSteps turned{
      {Matrix{{{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}, {0, 0, 0, 1}}}}}}};
  const std::string expected = pfm_of_mesh(triangles, false, turned);
  EXPECT_FALSE(expected == pfm_of_mesh(triangles, false));
  for (const char* members : {"", R"("up":"z")"}) {
    EXPECT_TRUE(pfm_of_model(stl_of_triangles(triangles, false), members) == expected);
    EXPECT_TRUE(pfm_of_model(ply_of_triangles(triangles, false, "ascii"), members) == expected);
  }
  const std::string upright = pfm_of_mesh(triangles, false);
  EXPECT_TRUE(pfm_of_model(glb_of_triangles(triangles, false), "") == upright);
  EXPECT_TRUE(pfm_of_model(obj_of_triangles(triangles, false), "") == upright);
}

}  // namespace
}  // namespace tia::test
