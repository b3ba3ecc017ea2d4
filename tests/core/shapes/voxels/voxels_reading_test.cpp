// How voxels are read and written, and what is wrong with them.
#include "core/shapes/voxels/voxels.h"
#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

std::string with_voxels(const std::string& size, const std::string& occupied,
                        const std::string& more = "") {
  return R"({"objects":[{"type":"voxels","size":)" + size + R"(,"occupied":)" + occupied + more +
         "}]}";
}

TEST(VoxelsReading, EveryFormIsWrittenAsItWasGiven) {
  for (const char* voxels :
       {R"({"cell":0.5,"occupied":[0,3,2,1],"size":[2,3,1]})",
        R"({"occupied":[[2,0],[3,2],[1,1]],"origin":[1,2,3],"size":[2,3,1]})",
        R"({"cell":[1,2,3],"occupied":[[0,0,0],[1,2,0],[0,0,0]],"size":[2,3,1]})",
        R"({"occupied":[[0,0,0,7],[1,2,0,255],[0,0,0,7]],"size":[2,3,1]})"}) {
    const auto read = read_described<Voxels>(parse_json(voxels));
    EXPECT_EQ(to_json(write_value(read)), voxels);
    EXPECT_EQ(read_described<Voxels>(write_value(read)), read);
  }
}

TEST(VoxelsReading, OneRunOfAMillionCellsStaysANumber) {
  const auto read =
      read_described<Voxels>(parse_json(R"({"size":[256,256,256],"occupied":[0,16777216]})"));
  EXPECT_EQ(read.occupied.numbers.size(), 2U);
  EXPECT_EQ(prepare(read).grid->cells.size(), 16'777'216U);
}

TEST(VoxelsReading, FaultsOfElementsNameTheirPlace) {
  expect_scene_refused(with_voxels("[2,2,2]", "5"),
                       {{wrong_type, "/objects/0/occupied", "5", "a list of run lengths"}});
  expect_scene_refused(with_voxels("[2,2,2]", "[]"),
                       {{wrong_type, "/objects/0/occupied", "[]", "cells [i, j, k]"}});
  expect_scene_refused(with_voxels("[2,2,2]", "[[1]]"),
                       {{wrong_type, "/objects/0/occupied/0", "[1]", "[count, material]"}});
  expect_scene_refused(
      with_voxels("[2,2,2]", "[[0,0,0],[0,0],[1,1,1,1],3]"),
      {{wrong_type, "/objects/0/occupied/1", "[0,0]", "[i, j, k], as the first"},
       {wrong_type, "/objects/0/occupied/2", "[1,1,1,1]", "[i, j, k], as the first"},
       {wrong_type, "/objects/0/occupied/3", "3", "[i, j, k], as the first"}});
  expect_scene_refused(with_voxels("[2,2,2]", R"([[0,0,0],[0,"x",-1]])"),
                       {{wrong_type, "/objects/0/occupied/1/1", R"("x")", "an integer"},
                        {out_of_range, "/objects/0/occupied/1/2", "-1", "an integer from 0"}});
  expect_scene_refused(with_voxels("[2,2,2]", "[0,1.5]"),
                       {{wrong_type, "/objects/0/occupied/1", "1.5", "an integer"}});
  expect_scene_refused(
      with_voxels("[2,2,2]", "[[0,0,0,0]]"),
      {{out_of_range, "/objects/0/occupied/0/3", "0", "an integer from 1 to 255"}});
  expect_scene_refused(
      with_voxels("[2,2,2]", "[[8,256]]"),
      {{out_of_range, "/objects/0/occupied/0/1", "256", "an integer from 0 to 255"}});
}

TEST(VoxelsReading, WhatLiesOutsideTheGridIsRefused) {
  expect_scene_refused(with_voxels("[2,3,4]", "[[0,0,0],[1,3,4]]"),
                       {{out_of_range, "/objects/0/occupied/1/1", "3", "an integer from 0 to 2"},
                        {out_of_range, "/objects/0/occupied/1/2", "4", "an integer from 0 to 3"}});
  expect_scene_refused(with_voxels("[2,3,4]", "[4,10,11]"),
                       {{out_of_range, "/objects/0/occupied/2", "11", "at most 10"}});
  expect_scene_refused(with_voxels("[2,3,4]", "[[20,0],[5,0]]"),
                       {{out_of_range, "/objects/0/occupied/1/0", "5", "at most 4"}});
  EXPECT_NO_THROW(read_scene(with_voxels("[2,3,4]", "[4,20]")));
}

TEST(VoxelsReading, NothingFilledIsRefused) {
  for (const char* empty : {"[24]", "[3,0,7]"})
    expect_scene_refused(with_voxels("[2,3,4]", empty), {{out_of_range, "/objects/0/occupied",
                                                          empty, "at least one filled cell"}});
  expect_scene_refused(
      with_voxels("[2,3,4]", "[[5,0]]"),
      {{out_of_range, "/objects/0/occupied", "[[5,0]]", "at least one filled cell"}});
}

TEST(VoxelsReading, ACellHasOneMaterialHoweverOftenItIsNamed) {
  const std::string materials = R"(,"materials":[{},{}])";
  expect_scene_refused(with_voxels("[2,2,2]", "[[1,1,1,2],[0,0,0,1],[1,1,1,1]]", materials),
                       {{FaultKind::conflict, "/objects/0/occupied/2/3", "1", "2, the material"}});
  EXPECT_NO_THROW(read_scene(with_voxels("[2,2,2]", "[[1,1,1,2],[1,1,1,2]]", materials)));
  EXPECT_NO_THROW(read_scene(with_voxels("[2,2,2]", "[[1,1,1],[1,1,1]]")));
}

TEST(VoxelsReading, GridsAreBoundedEachAndTogether) {
  expect_scene_refused(with_voxels("[1025,1,1]", "[0,1]"),
                       {{out_of_range, "/objects/0/size/0", "1025", "from 1 to 1024"}});
  expect_scene_refused(
      with_voxels("[1024,1024,17]", "[0,1]"),
      {{FaultKind::limit, "/objects/0/size", R"("17825792 cells")", "at most 16777216 cells"}});
  const std::string large = R"({"type":"voxels","size":[1024,1024,16],"occupied":[0,1]})";
  EXPECT_NO_THROW(read_scene(R"({"objects":[)" + large + "," + large + "]}"));
  expect_scene_refused(R"({"objects":[)" + large + "," + large +
                           R"(,{"type":"voxels","size":[1,1,1],"occupied":[0,1]}]})",
                       {{FaultKind::limit, "/objects/2/size", R"("1 cells more")",
                         "at most 33554432 cells together"}});
}

TEST(VoxelsReading, EdgesOfCellsAreAboveZero) {
  expect_scene_refused(with_voxels("[1,1,1]", "[0,1]", R"(,"cell":0)"),
                       {{out_of_range, "/objects/0/cell", "0", "a number above 0"}});
  expect_scene_refused(with_voxels("[1,1,1]", "[0,1]", R"(,"cell":[1,-1,1])"),
                       {{out_of_range, "/objects/0/cell/1", "-1", "a number above 0"}});
}

// ---- materials ------------------------------------------------------------------------------

TEST(VoxelsReading, NumbersAreThoseOfTheObjectsMaterials) {
  expect_scene_refused(with_voxels("[2,2,2]", "[[1,1,1,1]]"),
                       {{out_of_range, "/objects/0/occupied/0/3", "1", "has no materials"}});
  expect_scene_refused(with_voxels("[2,2,2]", "[[1,1,1,2],[0,1,1,3]]", R"(,"materials":[{},{}])"),
                       {{out_of_range, "/objects/0/occupied/1/3", "3", "an integer from 1 to 2"}});
  expect_scene_refused(with_voxels("[2,2,2]", "[[1,0],[2,3]]", R"(,"materials":[{},{}])"),
                       {{out_of_range, "/objects/0/occupied/1/1", "3", "an integer from 0 to 2"}});
}

TEST(VoxelsReading, OtherKindsWearOneMaterial) {
  expect_scene_refused(
      R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1,"materials":[{"color":0.5}]}]})",
      {{FaultKind::conflict, "/objects/0/materials", R"("1 materials")", "only of voxels"}});
}

TEST(VoxelsReading, UnknownNamesAreReportedAtTheirPlace) {
  expect_scene_refused(
      R"({"materials":{"stone":{},"wood":{}},"objects":[{"type":"group","children":[
      {"type":"voxels","size":[2,1,1],"occupied":[[1,1],[1,2]],"materials":["wood","ston"]}]}]})",
      {{FaultKind::unknown_name, "/objects/0/children/0/materials/1", R"("ston")",
        "one of stone, wood", "stone"}});
}

TEST(VoxelsReading, NumberedMaterialsAreBoundedTogether) {
  std::string list = "{}";
  for (int i = 1; i < 33'000; ++i) list += ",{}";
  const std::string one =
      R"({"type":"voxels","size":[1,1,1],"occupied":[0,1],"materials":[)" + list + "]}";
  expect_scene_refused(R"({"objects":[)" + one + "," + one + "]}",
                       {{FaultKind::limit, "/objects/1/materials", "", "at most 65536 numbered"}});
}

}  // namespace
}  // namespace tia
