// What a mesh may be, as the scene writes it.
#include <gtest/gtest.h>

#include "core/shapes/mesh/mesh.h"
#include "tests/core/faults.h"

namespace tia {
namespace {

using enum FaultKind;
using test::Expected;

std::string mesh_json(const std::string& more, const char* indices = "[0,1,2]") {
  return std::string(R"({"positions":[0,0,0, 1,0,0, 0,1,0],"indices":)")
      .append(indices)
      .append(more)
      .append("}");
}
Mesh read_mesh(const std::string& json) { return read_described<Mesh>(parse_json(json)); }
const auto expect_mesh_refused = test::refusal_by([](const std::string& json) { read_mesh(json); });

TEST(MeshDescription, CountsItsVerticesAndTriangles) {
  const Mesh two = read_mesh(R"({"positions":[0,0,0,1,0,0,0,1,0,1,1,0],"indices":[0,1,2,2,1,3]})");
  EXPECT_EQ(two.vertices(), 4U);
  EXPECT_EQ(two.triangles(), 2U);
}

TEST(MeshDescription, HasOneTriangleAtLeast) {
  expect_mesh_refused("{}", {{missing, "/positions", "", "x, y and z of each vertex: an array of"},
                             {missing, "/indices", "", "an integer from 0 to 4294967295"}});
  expect_mesh_refused(R"({"positions":[],"indices":[]})",
                      {{wrong_type, "/positions", "[]", "an array of at least 9"},
                       {wrong_type, "/indices", "[]", "an array of at least 3"}});
}

TEST(MeshDescription, ListsAreWholeTriples) {
  expect_mesh_refused(R"({"positions":[0,0,0,1,0,0,0,1,0,5],"indices":[0,1,2,0]})",
                      {{wrong_type, "/positions", "\"10 numbers\"", "a multiple of 3"},
                       {wrong_type, "/indices", "\"4 numbers\"", "a multiple of 3"}});
}

TEST(MeshDescription, IndicesPointAtPositions) {
  expect_mesh_refused(mesh_json("", "[0,1,3,4294967295,2,0]"),
                      {{out_of_range, "/indices/2", "3", "the index of a position, from 0 to 2"},
                       {out_of_range, "/indices/3", "4294967295", "from 0 to 2"}});
  // 0, 1, 3 as bytes
  expect_mesh_refused(mesh_json("", R"({"uint32":"AAAAAAEAAAADAAAA"})"),
                      {{out_of_range, "/indices/2", "3", "from 0 to 2"}});
}

TEST(MeshDescription, NormalsAndUvsAreOneAVertex) {
  EXPECT_NO_THROW(read_mesh(mesh_json(R"(,"normals":[0,0,1,0,0,1,0,0,9],"uvs":[0,0,1,0,0,1])")));
  EXPECT_NO_THROW(read_mesh(mesh_json(R"(,"colors":[0,0,1,1,0,0,1,0,1,1,1,0.5])")));
  expect_mesh_refused(
      mesh_json(R"(,"colors":[0,0,1])"),
      {{wrong_type, "/colors", "\"3 numbers\"", "4 numbers for each of the 3 vertices, or none"}});
  expect_mesh_refused(mesh_json(R"(,"normals":[0,0,1],"uvs":[0,0,1])"),
                      {{wrong_type, "/normals", "\"3 numbers\"", "3 numbers for each of the 3"},
                       {wrong_type, "/uvs", "\"3 numbers\"", "2 numbers for each of the 3"}});
}

TEST(MeshDescription, NormalsHaveALength) {
  expect_mesh_refused(mesh_json(R"(,"normals":[0,0,1,0,0,0,1e-200,0,0])"),
                      {{out_of_range, "/normals/3", "[0,0,0]", "a normal of some length"},
                       {out_of_range, "/normals/6", "[1e-200,0,0]", "a normal of some length"}});
}

TEST(MeshDescription, ListsThatAreLeftOutAreNotWritten) {
  EXPECT_EQ(to_json(write_value(read_mesh(mesh_json("")))),
            R"({"indices":[0,1,2],"positions":[0,0,0,1,0,0,0,1,0]})");
}

}  // namespace
}  // namespace tia
