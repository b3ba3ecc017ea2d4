// PLY files that are refused: where they are wrong, and that nothing is made of what they claim.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/core/models/ply_files.h"

namespace tia {
namespace {

using namespace test;

struct PlyRefused {
  std::string file;
  FaultKind kind;
  std::optional<std::size_t> line;
};

void expect_refused(const std::vector<PlyRefused>& files) {
  for (const PlyRefused& each : files) {
    const ReadModel read = read_ply_file(each.file);
    ASSERT_FALSE(read.faults.empty()) << each.file;
    EXPECT_EQ(read.fault().kind, each.kind) << each.file << describe(read.fault());
    EXPECT_EQ(read.fault().line, each.line) << each.file << describe(read.fault());
  }
}

// One quadrilateral and what else there may be, as bytes.
std::string ply_quadrilateral(std::string_view encoding) {
  PlyFile file;
  file.line("comment x").element("vertex", 4).list("char", "short", "skipped");
  for (const char* name : {"x", "y", "z"}) file.property("float", name);
  for (const char* name : {"red", "green", "blue"}) file.property("uchar", name);
  file.element("face", 1).list("uchar", "int", "vertex_indices");
  file.element("tristrips", 1).list("int", "int", "vertex_indices");
  for (const int corner : {0, 1, 3, 2}) {
    file.put_list("char", "short", {7, 8}).put("float", corner & 1).put("float", corner >> 1);
    file.put("float", 0);
    for (int i = 0; i < 3; ++i) file.put("uchar", 60 * i);
    file.end_row();
  }
  file.put_list("uchar", "int", {0, 1, 2, 3}).end_row();
  return file.put_list("int", "int", {0, 1, 2, -1, 3, 2, 1}).end_row().in(encoding);
}

TEST(PlyFaults, AHeaderTellsItsLine) {
  const std::string start = "ply\nformat ascii 1.0\n";
  expect_refused({
      {"", FaultKind::malformed, 1},
      {"plx\n", FaultKind::malformed, 1},
      {"ply\n", FaultKind::malformed, 1},
      {start, FaultKind::malformed, 2},
      {"ply\nend_header\n", FaultKind::missing, 2},
      {"ply\nformat ascii 1.1\n", FaultKind::malformed, 2},
      {"ply\nformat text 1.0\n", FaultKind::malformed, 2},
      {start + "format ascii 1.0\n", FaultKind::conflict, 3},
      {start + "elements vertex 1\n", FaultKind::malformed, 3},
      {start + "element\n", FaultKind::malformed, 3},
      {start + "element vertex\n", FaultKind::malformed, 3},
      {start + "element vertex -1\n", FaultKind::malformed, 3},
      {start + "element vertex 1x\n", FaultKind::malformed, 3},
      {start + "element vertex 1 1\n", FaultKind::malformed, 3},
      {start + "element vertex 99999999999999999999\n", FaultKind::malformed, 3},
      {start + "property float x\n", FaultKind::malformed, 3},
      {start + "element vertex 1\nproperty real x\n", FaultKind::malformed, 4},
      {start + "element vertex 1\nproperty float\n", FaultKind::malformed, 4},
      {start + "element vertex 1\nproperty list float int x\n", FaultKind::malformed, 4},
      {start + "element vertex 1\nproperty list uchar x\n", FaultKind::malformed, 4},
      {start + "element vertex 1\nend_header\n1\n", FaultKind::malformed, 3},
      {start + "element x 1\nproperty int x\nend_header\n1\n", FaultKind::missing, std::nullopt},
      {start + "element vertex 1\nproperty int x\nproperty int z\nend_header\n1 1\n",
       FaultKind::missing, 3},
      {ply_text(1, "element vertex 1\nproperty int x\n", "1 1 1\n1\n"), FaultKind::conflict, 7},
      {ply_text(3, "element face 1\nproperty int vertex_index\n", ply_corners + "1\n"),
       FaultKind::missing, 7},
  });
  std::string many = start + "element vertex 0\n";
  for (int i = 0; i < 5000; ++i) many += "property int x\n";
  expect_refused({{many + "end_header\n", FaultKind::limit, 4098}});
}

TEST(PlyFaults, ABodyTellsItsLine) {
  const auto with_face = [](const std::string& face) {
    return ply_text(3, ply_face_lines, ply_corners + face);
  };
  expect_refused({
      {ply_text(2, "", "0 0 0\n0.5 0.5\n"), FaultKind::malformed, 9},
      {ply_text(2, "", "0 0 0\n\n0 0 0 0\n"), FaultKind::malformed, 10},
      {ply_text(2, "", "0 0 0 0 0 0\n     "), FaultKind::malformed, 8},
      {ply_text(1, "", "0 zero 0\n"), FaultKind::malformed, 8},
      {ply_text(1, "", "0 0x1 0\n"), FaultKind::malformed, 8},
      {ply_text(1, "", "0 nan 0\n"), FaultKind::out_of_range, 8},
      {ply_text(1, "", "0 0 -1e10\n"), FaultKind::out_of_range, 8},
      {ply_text(1, "", "0 0 1e999\n"), FaultKind::out_of_range, 8},
      {ply_text(1, "property char i\n", "0 0 0 128\n"), FaultKind::out_of_range, 9},
      {ply_text(1, "property uint i\n", "0 0 0 -1\n"), FaultKind::out_of_range, 9},
      {ply_text(1, "property int i\n", "0 0 0 0.5\n"), FaultKind::out_of_range, 9},
      {ply_text(1, "property float s\nproperty float t\n", "0 0 0 0 inf\n"),
       FaultKind::out_of_range, 10},
      {ply_text(1, "property float nx\nproperty float ny\nproperty float nz\n", "0 0 0 0 1e39 0\n"),
       FaultKind::out_of_range, 11},
      {ply_text(1, "property float red\nproperty float green\nproperty float blue\n",
                "0 0 0 0 1.5 0\n"),
       FaultKind::out_of_range, 11},
      {with_face("3 0 1\n"), FaultKind::malformed, 13},
      {with_face("3 0 1 2 2\n"), FaultKind::malformed, 13},
      {with_face("3 0 1 3\n"), FaultKind::out_of_range, 13},
      {with_face("3 0 1 -1\n"), FaultKind::out_of_range, 13},
      {with_face("-3 0 1 2\n"), FaultKind::out_of_range, 13},
      {with_face("3 0 1 1.5\n"), FaultKind::out_of_range, 13},
      {ply_text(3, "element face 1\nproperty list int int vertex_index\n", ply_corners + "-1 0\n"),
       FaultKind::malformed, 13},
      {ply_text(3, "element tristrips 1\nproperty list int int vertex_index\n",
                ply_corners + "4 0 1 2 -2\n"),
       FaultKind::out_of_range, 13},
  });
}

TEST(PlyFaults, IndependentOnesComeTogether) {
  std::string body;
  for (int i = 0; i < 30; ++i) body += i % 2 == 0 ? "0 0 nan\n" : "0 0 0\n";
  const ReadModel read = read_ply_file(ply_text(30, "", body));
  ASSERT_EQ(read.faults.size(), 15U);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(read.faults[i].line, 8 + 2 * i);
  EXPECT_EQ(read_ply_file(ply_text(60, "", body + body)).faults.size(), Faults::most);
}

TEST(PlyFaults, OfBytesTellTheirRow) {
  PlyFile file;
  file.element("vertex", 3);
  for (const char* name : {"x", "y", "z"}) file.property("double", name);
  for (int i = 0; i < 9; ++i)
    file.put("double", i == 5 ? std::numeric_limits<double>::quiet_NaN() : i);
  for (const std::string_view encoding : {ply_encodings[1], ply_encodings[2]}) {
    const ReadModel read = read_ply_file(file.in(encoding));
    ASSERT_EQ(read.faults.size(), 1U);
    EXPECT_EQ(read.fault().kind, FaultKind::out_of_range);
    EXPECT_EQ(read.fault().line, std::nullopt);
    EXPECT_NE(read.fault().allowed.find("in vertex 1"), std::string::npos);
  }
}

// ---- what is claimed ------------------------------------------------------------------------

TEST(PlyFaults, CountsThatTheFileCannotHoldCostNothing) {
  for (const std::string count :
       {"2", "4000000000", "1431655766", "6148914691236517206", "18446744073709551615"})
    for (const std::string_view encoding : ply_encodings) {
      const std::string file = "ply\nformat " + std::string(encoding) + " 1.0\nelement vertex " +
                               count +
                               "\nproperty float x\nproperty float y\nproperty float "
                               "z\nend_header\n";
      const ReadModel read =
          read_ply_file(file + (encoding == "ascii" ? "0 0 0\n" : "123456789012"),
                        {.vertices = std::numeric_limits<std::uint64_t>::max()});
      ASSERT_EQ(read.faults.size(), 1U) << count;
      EXPECT_EQ(read.fault().kind, FaultKind::malformed);
      EXPECT_EQ(read.fault().line, 3U);
    }
  // Elements take from what others leave.
  expect_refused(
      {{ply_text(1, "element face 3\nproperty list uchar int vertex_index\n", "0 0 0 0\n"),
        FaultKind::malformed, 7}});
}

TEST(PlyFaults, ListsThatTheFileCannotHoldCostNothing) {
  for (const char* type : {"uint", "ushort", "int"})
    for (const char* name : {"vertex_index", "skipped"})
      for (const std::string_view encoding : {ply_encodings[1], ply_encodings[2]}) {
        PlyFile file;
        file.element("vertex", 1);
        for (const char* axis : {"x", "y", "z"}) file.property("uchar", axis);
        file.element("face", 1).list("uchar", "int", "vertex_index").list(type, "double", name);
        for (int i = 0; i < 3; ++i) file.put("uchar", i);
        file.put_list("uchar", "int", {0, 0, 0}).put(type, type[0] == 'u' ? 65535 : 2147483647);
        for (int i = 0; i < 9; ++i) file.put("double", 0);
        const ReadModel read = read_ply_file(file.in(encoding));
        ASSERT_EQ(read.faults.size(), 1U);
        EXPECT_EQ(read.fault().kind, FaultKind::malformed);
      }
}

TEST(PlyFaults, LimitsAreThoseThatAreGiven) {
  const auto refused = [](const std::string& file, const ModelLimits& limits) {
    const ReadModel read = read_ply_file(file, limits);
    return !read.faults.empty() && read.fault().kind == FaultKind::limit;
  };
  for (const std::string_view encoding : ply_encodings) {
    const std::string file = ply_quadrilateral(encoding);  // and a strip of two triangles
    EXPECT_TRUE(refused(file, {.triangles = 3}));
    EXPECT_FALSE(refused(file, {.triangles = 4}));
    EXPECT_TRUE(refused(file, {.vertices = 3}));
    EXPECT_FALSE(refused(file, {.vertices = 4}));
    EXPECT_TRUE(refused(file, {.polygon_corners = 3}));
    EXPECT_FALSE(refused(file, {.polygon_corners = 4}));
  }
}

TEST(PlyFaults, WhatIsCutOffOrDamagedEnds) {
  Random random(831);
  for (const std::string_view encoding : ply_encodings) {
    const std::string file = ply_quadrilateral(encoding);
    EXPECT_TRUE(read_ply_file(file).faults.empty());
    for (std::size_t size = 0; size < file.size(); ++size) {
      const ReadModel read = read_ply_file(file.substr(0, size));
      expect_sound_model(read);
      // But for a text's last line end and the blank before it.
      if (encoding != "ascii" || size + 2 < file.size()) {
        EXPECT_FALSE(read.faults.empty()) << size;
      }
    }
    for (int i = 0; i < 1000; ++i) expect_sound_model(read_ply_file(damaged_file(file, random)));
  }
}

TEST(PlyFaults, ReadingEndsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  PlyFile file;
  file.element("vertex", 5000);
  for (const char* axis : {"x", "y", "z"}) file.property("uchar", axis);
  for (int i = 0; i < 15000; ++i) {
    file.put("uchar", 1);
    if (i % 3 == 2) file.end_row();
  }
  for (const std::string_view encoding : ply_encodings) {
    const std::string bytes = file.in(encoding);
    Faults faults(stop.get_token());
    Model model;
    EXPECT_THROW(read_ply(ModelFiles{{{"a.ply", model_bytes(bytes)}}, 0}, {}, faults, model),
                 Stopped);
  }
}

}  // namespace
}  // namespace tia
