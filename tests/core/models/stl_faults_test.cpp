// STL files that are refused: where they are wrong, and that others are never read past their end.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/core/models/stl_files.h"

namespace tia {
namespace {

using namespace test;

struct StlRefused {
  std::string text;
  FaultKind kind;
  std::size_t line;
};

TEST(StlFaults, AFaultOfATextTellsItsLine) {
  const std::string head = "solid x\nfacet normal 0 0 1\nouter loop\n";
  for (const StlRefused& each :
       std::vector<StlRefused>{{"solid x\n", FaultKind::malformed, 2},
                               {"solid x\nfacets", FaultKind::malformed, 2},
                               {"solid x\nendsolid\n\nsolit", FaultKind::malformed, 4},
                               {"solid x\r\nfacet\r\nabnormal", FaultKind::malformed, 3},
                               {"solid x\rfacet\rabnormal", FaultKind::malformed, 3},
                               {"solid x\nfacet normal 0 0\nouter loop", FaultKind::malformed, 3},
                               {head + "vertex 1 2\nvertex 1 2 3", FaultKind::malformed, 5},
                               {head + "vertex 1 2 0x3", FaultKind::malformed, 4},
                               {head + "vertex 1 2 +-3", FaultKind::malformed, 4},
                               {head + "vertex 1 2 3 4", FaultKind::malformed, 4},
                               {head + "vertex 1 2 nan\n", FaultKind::out_of_range, 4},
                               {head + "vertex 1 1e10 3\n", FaultKind::out_of_range, 4},
                               {head + "vertex 1 -1e999 3\n", FaultKind::out_of_range, 4},
                               {head + "vertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0\nvertex 0 0 0",
                                FaultKind::malformed, 7}}) {
    const ReadModel read = read_stl_file(each.text);
    ASSERT_FALSE(read.faults.empty()) << each.text;
    EXPECT_EQ(read.fault().kind, each.kind) << each.text;
    EXPECT_EQ(read.fault().line, each.line) << each.text;
  }
}

TEST(StlFaults, CornersAreFiniteAndNear) {
  for (const float x : {std::numeric_limits<float>::quiet_NaN(), 2e9F, -2e9F,
                        std::numeric_limits<float>::infinity()}) {
    std::vector<StlTriangle> triangles(30, StlTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0});
    triangles[3][7] = x;
    ReadModel read = read_stl_file(stl_bytes(triangles));
    ASSERT_EQ(read.faults.size(), 1U);
    EXPECT_EQ(read.fault().kind, FaultKind::out_of_range);
    EXPECT_NE(read.fault().allowed.find("triangle 3"), std::string::npos);
    for (StlTriangle& triangle : triangles) triangle[0] = x;
    EXPECT_EQ(read_stl_file(stl_bytes(triangles)).faults.size(), Faults::most);
  }
  EXPECT_TRUE(read_stl_file(stl_bytes({{1e9F, -1e9F, 0, 0, 0, 0, 0, 0, 1}})).faults.empty());
}

TEST(StlFaults, LimitsAreThoseThatAreGiven) {
  const auto refused = [](const std::string& file, const ModelLimits& limits) {
    const ReadModel read = read_stl_file(file, limits);
    return !read.faults.empty() && read.fault().kind == FaultKind::limit;
  };
  const std::string bytes = stl_bytes({{0, 0, 0, 1, 0, 0, 0, 1, 0}, {0, 0, 0, 2, 0, 0, 0, 2, 0}}),
                    text = "solid a\n" + stl_facet + "endsolid\nsolid b\n" + stl_facet + "endsolid";
  for (const std::string& file : {bytes, text}) {
    EXPECT_TRUE(refused(file, {.triangles = 1}));
    EXPECT_FALSE(refused(file, {.triangles = 2}));
  }
  EXPECT_TRUE(refused(bytes, {.vertices = 4}));
  EXPECT_FALSE(refused(bytes, {.vertices = 5}));
  EXPECT_TRUE(refused(text, {.vertices = 5}));
  EXPECT_FALSE(refused(text, {.vertices = 6}));
  EXPECT_TRUE(refused(text, {.nodes = 1}));
  EXPECT_FALSE(refused(text, {.nodes = 2}));
}

TEST(StlFaults, NothingIsAModelOfNothing) {
  const ReadModel read = read_stl_file(stl_bytes({}));
  EXPECT_TRUE(read.faults.empty());
  EXPECT_TRUE(read.model.meshes.empty());
}

TEST(StlFaults, WhatIsCutOffOrDamagedEnds) {
  const std::string text = "solid a\n" + stl_facet + "endsolid\nsolid b\n" + stl_facet + "endsolid";
  for (std::size_t size = 0; size <= text.size(); ++size)
    expect_sound_model(read_stl_file(text.substr(0, size)));
  Random random(813);
  const std::string bytes = stl_bytes(stl_on_a_grid(random, 5, 2));
  for (int i = 0; i < 1000; ++i) {
    expect_sound_model(read_stl_file(damaged_file(text, random)));
    expect_sound_model(read_stl_file(damaged_file(bytes, random)));
  }
}

TEST(StlFaults, ReadingEndsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::string text = "solid\n";
  for (int i = 0; i < 5000; ++i) text += stl_facet;
  for (const std::string& file : {stl_bytes(std::vector<StlTriangle>(5000)), text + "endsolid\n"}) {
    Faults faults(stop.get_token());
    Model model;
    EXPECT_THROW(read_stl(ModelFiles{{{"a.stl", model_bytes(file)}}, 0}, {}, faults, model),
                 Stopped);
  }
}

}  // namespace
}  // namespace tia
