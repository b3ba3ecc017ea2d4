// TIFF as tests read it: by the specification alone, of what baseline readers take.
// Source: Adobe, TIFF Revision 6.0 (1992), sections 2 to 8 and 19.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tia::test {

/// TiffPicture: its numbers, pixel by pixel, row 0 on top, and what its tags say.
struct TiffPicture {
  std::size_t width = 0, height = 0, channels = 0;
  std::vector<float> numbers;
  std::map<std::uint32_t, std::vector<std::uint32_t>> tags;

  float at(std::size_t x, std::size_t y, std::size_t channel = 0) const {
    return numbers[(y * width + x) * channels + channel];
  }
};

/// TiffReader: fails the test where something lies outside of the file, or tags do not ascend.
class TiffReader {
 public:
  explicit TiffReader(const std::string& file) : file_(file) {}

  TiffPicture read() {
    EXPECT_EQ(file_.substr(0, 2), "II");
    EXPECT_EQ(number(2, 2), 42U);
    std::size_t at = number(4, 4);
    EXPECT_EQ(at % 2, 0U);
    const std::size_t count = number(at, 2);
    for (std::size_t i = 0; i < count; ++i) entry(at + 2 + 12 * i);
    EXPECT_EQ(number(at + 2 + 12 * count, 4), 0U) << "one directory";
    picture_.width = one(256), picture_.height = one(257), picture_.channels = one(277);
    take_strips();
    return picture_;
  }

 private:
  std::uint32_t number(std::size_t at, std::size_t bytes) const {
    if (at + bytes > file_.size()) {
      ADD_FAILURE() << "beyond the file: " << at;
      return 0;
    }
    std::uint32_t value = 0;
    for (std::size_t i = bytes; i-- > 0;)
      value = value << 8U | static_cast<unsigned char>(file_[at + i]);
    return value;
  }
  void entry(std::size_t at) {
    const std::uint32_t tag = number(at, 2), type = number(at + 2, 2);
    EXPECT_TRUE(picture_.tags.empty() || picture_.tags.rbegin()->first < tag) << tag;
    EXPECT_TRUE(type == 3 || type == 4 || type == 5) << type;
    const std::size_t size = type == 3 ? 2 : 4, count = number(at + 4, 4) * (type == 5 ? 2U : 1U);
    const std::size_t from = size * count <= 4 ? at + 8 : number(at + 8, 4);
    EXPECT_EQ(from % 2, 0U) << "values begin on words";
    for (std::size_t i = 0; i < count; ++i)
      picture_.tags[tag].push_back(number(from + i * size, size));
  }
  std::uint32_t one(std::uint32_t tag) {
    const std::vector<std::uint32_t>& values = picture_.tags[tag];
    EXPECT_FALSE(values.empty()) << tag;
    return values.empty() ? 0 : values.front();
  }
  void take_strips() {
    const auto offsets = picture_.tags[273], bytes = picture_.tags[279];
    ASSERT_EQ(offsets.size(), bytes.size());
    for (std::size_t i = 0; i < offsets.size(); ++i)
      for (std::size_t at = 0; at < bytes[i]; at += 4)
        picture_.numbers.push_back(std::bit_cast<float>(number(offsets[i] + at, 4)));
    ASSERT_EQ(picture_.numbers.size(), picture_.width * picture_.height * picture_.channels);
  }

  const std::string& file_;
  TiffPicture picture_;
};

inline TiffPicture read_tiff(const std::string& file) { return TiffReader(file).read(); }

}  // namespace tia::test
