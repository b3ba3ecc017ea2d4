// PLY: numbers, lists, elements and lines are the same in every encoding.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "tests/core/models/ply_files.h"

namespace tia {
namespace {

using namespace test;

TEST(PlyEncodings, LinesEndWithCrLfOrBoth) {
  const std::string text =
      ply_text(3, ply_face_lines + "comment x\n\n", ply_corners + "\n3 0 1 2\n");
  const ReadModel expected = read_ply_file(text);
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    const ReadModel read = read_ply_file(other);
    ASSERT_TRUE(read.faults.empty()) << describe(read.fault());
    EXPECT_EQ(read.model, expected.model);
  }
  // The first byte after a CR may look like an LF.
  PlyFile file;
  file.element("vertex", 1);
  for (const char* name : {"x", "y", "z"}) file.property("uchar", name);
  file.put("uchar", 10).put("uchar", 13).put("uchar", 32);
  std::string bytes = file.in("binary_little_endian");
  std::replace(bytes.begin(), bytes.end() - 3, '\n', '\r');
  EXPECT_EQ(read_ply_file(bytes).part().positions, (std::vector<double>{10, 13, 32}));
}

TEST(PlyEncodings, NumbersOfEveryTypeAreThemselves) {
  struct Range {
    const char *name, *other;
    double least, most;
  };
  for (const Range& range : {Range{"char", "int8", -128, 127},
                             {"uchar", "uint8", 0, 255},
                             {"short", "int16", -32768, 32767},
                             {"ushort", "uint16", 0, 65535},
                             {"int", "int32", -1e9, 999'999'999},
                             {"uint", "uint32", 0, 1e9},
                             {"float", "float32", -1e9, 0x1.8p-100},
                             {"double", "float64", -0.1, 1e9}})
    for (const char* type : {range.name, range.other}) {
      PlyFile file;
      file.element("vertex", 1);
      for (const char* name : {"z", "x", "y"}) file.property(type, name);
      file.put(type, range.least).put(type, range.most).put(type, 1).end_row();
      EXPECT_EQ(read_in_all(file).part().positions,
                (std::vector<double>{range.most, 1, range.least}))
          << type;
    }
}

// A file of random types, properties and rows, and what must come of it.
struct RandomPly {
  PlyFile file;
  std::vector<double> positions;
  std::size_t faces = 0, triangles = 0;

  explicit RandomPly(Random& random) : random_(random) {
    const int vertices = random.whole(3, 9), others = random.below(4);
    faces = static_cast<std::size_t>(random.below(7));
    declare(static_cast<std::size_t>(vertices), static_cast<std::size_t>(others));
    for (int i = 0; i < others; ++i) {
      put_list(more_, 5, 100);
      file.put(more_, random.below(100)).end_row();
    }
    for (int i = 0; i < vertices; ++i) put_vertex();
    for (std::size_t i = 0; i < faces; ++i) {
      file.put(more_, 1);
      const std::size_t corners = put_list(index_, 7, vertices);
      triangles += corners < 3 ? 0 : corners - 2;
      put_list(more_, 3, 100);
      file.end_row();
    }
  }

 private:
  std::string type(int most) {
    constexpr std::array<const char*, 8> types{"char", "uchar", "short", "ushort",
                                               "int",  "uint",  "float", "double"};
    return types[static_cast<std::size_t>(random_.below(most))];
  }
  void declare(std::size_t vertices, std::size_t others) {
    file.element("other", others).list(count_, more_, "skipped").property(more_, "x");
    file.element("vertex", vertices).property(more_, "skipped");
    for (const char* name : {"x", "y", "z"}) file.property(place_, name);
    file.list(count_, more_, "nx").element("face", faces).property(more_, "skipped");
    file.list(count_, index_, "vertex_index").list(count_, more_, "other");
  }
  void put_vertex() {
    file.put(more_, random_.below(100));
    for (int axis = 0; axis < 3; ++axis) {
      positions.push_back(random_.below(100));
      file.put(place_, positions.back());
    }
    put_list(more_, 3, 100);
    file.end_row();
  }
  std::size_t put_list(const std::string& of, int most, int below) {
    std::vector<int> numbers(static_cast<std::size_t>(random_.below(most + 1)));
    for (int& each : numbers) each = random_.below(below);
    file.put_list(count_, of, numbers);
    return numbers.size();
  }

  Random& random_;
  std::string count_ = type(6), index_ = type(6), place_ = type(8), more_ = type(8);
};

TEST(PlyEncodings, RandomFilesAreTheSameInAll) {
  Random random(821);
  for (int round = 0; round < 100; ++round) {
    const RandomPly expected(random);
    const ReadModel read = read_in_all(expected.file);
    EXPECT_EQ(read.part().positions, expected.positions);
    EXPECT_EQ(read.part().triangles(), expected.triangles);
    EXPECT_EQ(read.part().points, expected.faces == 0);
  }
}

TEST(PlyEncodings, WhatIsNotUsedIsTold) {
  PlyFile file = ply_vertices(1);
  file.property("float", "confidence").property("int", "red").element("camera", 1);
  file.property("double", "focal").element("none", 0).property("int", "x");
  for (int i = 0; i < 3; ++i) file.put("float", i);
  file.put("float", 1).put("int", 1).end_row().put("double", 5).end_row();
  const ReadModel read = read_in_all(file);
  ASSERT_EQ(read.model.warnings.size(), 2U);
  EXPECT_EQ(read.model.warnings[0].text, "not used of element vertex: confidence, red");
  EXPECT_EQ(read.model.warnings[0].line, 3U);
  EXPECT_EQ(read.model.warnings[1].text, "not used of element camera: all");
  EXPECT_EQ(read.model.warnings[1].line, 9U);
}

}  // namespace
}  // namespace tia
