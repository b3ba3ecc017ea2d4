#include "tests/core/png/inflate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace tia::test {
namespace {

void require(bool holds, const char* otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

/// Bits, the lowest of each byte first (RFC 1951, 3.1.1).
class Bits {
 public:
  explicit Bits(std::string_view bytes) : left_(bytes) {}
  unsigned take(int count) {
    unsigned value = 0;
    for (int i = 0; i < count; ++i) value |= one() << i;
    return value;
  }
  unsigned one() {
    if (used_ == 8) {
      left_.remove_prefix(1);
      used_ = 0;
    }
    require(!left_.empty(), "the stream is cut short");
    return static_cast<unsigned char>(left_[0]) >> used_++ & 1U;
  }
  /// What follows the byte that was begun.
  std::string_view& bytes() {
    if (used_ > 0) left_.remove_prefix(1);
    used_ = 0;
    return left_;
  }

 private:
  std::string_view left_;
  int used_ = 0;  // bits of its first byte
};

/// A Huffman code by the lengths of its words, in bits; 0 = unused (RFC 1951, 3.2.2).
class Code {
 public:
  Code(const std::uint8_t* lengths, std::size_t symbols, bool may_lack_words) {
    for (std::size_t i = 0; i < symbols; ++i) ++of_length_[lengths[i]];
    of_length_[0] = 0;
    int words = 1;  // that are left
    for (std::size_t length = 1; length <= longest; ++length) {
      words = 2 * words - of_length_[length];
      require(words >= 0, "a code has more words than there are");
      for (std::size_t i = 0; i < symbols; ++i)
        if (lengths[i] == length) symbols_.push_back(static_cast<int>(i));
    }
    // "One distance code of zero bits means that there are no distance codes used at all", and
    // where there is one alone it has one bit.
    const bool is_one_bit = symbols_.empty() || (symbols_.size() == 1 && of_length_[1] == 1);
    require(words == 0 || (may_lack_words && is_one_bit), "a code lacks words");
  }
  int next(Bits& bits) const {
    int word = 0, first = 0, index = 0;
    for (std::size_t length = 1; length <= longest; ++length) {
      word = 2 * word + static_cast<int>(bits.one());
      first = 2 * first;
      const int count = of_length_[length];
      if (word - first < count) return symbols_[static_cast<std::size_t>(index + word - first)];
      index += count;
      first += count;
    }
    throw std::runtime_error("bits that are no word of the code");
  }

 private:
  static constexpr std::size_t longest = 15;
  std::array<int, longest + 1> of_length_{};
  std::vector<int> symbols_;  // in the order of their words
};

/// Inflater: RFC 1951, 3.2.3 and on.
class Inflater {
 public:
  Inflater(std::string_view stream, std::size_t window, std::size_t most)
      : bits_(stream), window_(window), most_(most) {}

  // Returns: what follows the last block.
  std::string_view run() {
    for (bool last = false; !last;) {
      last = bits_.one() != 0;
      switch (bits_.take(2)) {
        case 0: stored(); break;
        case 1: fixed(); break;
        case 2: dynamic(); break;
        default: throw std::runtime_error("a block of no known type");
      }
    }
    return bits_.bytes();
  }
  std::string out;

 private:
  void put(char byte) {
    require(out.size() < most_, "more bytes than there are pixels");
    out += byte;
  }

  void stored() {
    std::string_view& bytes = bits_.bytes();
    require(bytes.size() >= 4, "a stored block is cut short");
    const auto byte = [&](std::size_t i) {
      return std::size_t{static_cast<std::uint8_t>(bytes[i])};
    };
    const std::size_t length = byte(0) + 256 * byte(1);
    require(length == 0xFFFF - (byte(2) + 256 * byte(3)), "a stored block's lengths differ");
    bytes.remove_prefix(4);
    require(bytes.size() >= length, "a stored block is cut short");
    for (const char each : bytes.substr(0, length)) put(each);
    bytes.remove_prefix(length);
  }

  void fixed() {
    std::array<std::uint8_t, 288 + 32> lengths{};
    std::fill_n(lengths.begin(), 144, std::uint8_t{8});
    std::fill_n(lengths.begin() + 144, 112, std::uint8_t{9});
    std::fill_n(lengths.begin() + 256, 24, std::uint8_t{7});
    std::fill_n(lengths.begin() + 280, 8, std::uint8_t{8});
    std::fill_n(lengths.begin() + 288, 32, std::uint8_t{5});
    compressed(Code(lengths.data(), 288, false), Code(lengths.data() + 288, 32, false));
  }

  void dynamic() {
    const std::size_t literals = bits_.take(5) + 257, distances = bits_.take(5) + 1;
    const std::size_t given = bits_.take(4) + 4;
    require(literals <= 286 && distances <= 30, "more symbols than there are");
    static constexpr std::array<std::uint8_t, 19> order = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                           11, 4,  12, 3, 13, 2, 14, 1, 15};
    std::array<std::uint8_t, 19> of_lengths{};
    for (std::size_t i = 0; i < given; ++i)
      of_lengths[order[i]] = static_cast<std::uint8_t>(bits_.take(3));
    const Code code(of_lengths.data(), of_lengths.size(), false);
    std::vector<std::uint8_t> lengths;
    while (lengths.size() < literals + distances) add_lengths(code.next(bits_), lengths);
    require(lengths.size() == literals + distances, "more lengths of words than symbols");
    require(lengths[256] != 0, "a block without an end");
    compressed(Code(lengths.data(), literals, false),
               Code(lengths.data() + literals, distances, true));
  }
  void add_lengths(int symbol, std::vector<std::uint8_t>& lengths) {
    if (symbol < 16) return lengths.push_back(static_cast<std::uint8_t>(symbol));
    require(symbol != 16 || !lengths.empty(), "nothing to be repeated");
    const std::uint8_t length = symbol == 16 ? lengths.back() : std::uint8_t{0};
    const unsigned times = symbol == 16   ? 3 + bits_.take(2)
                           : symbol == 17 ? 3 + bits_.take(3)
                                          : 11 + bits_.take(7);
    lengths.insert(lengths.end(), times, length);
  }

  void compressed(const Code& literals, const Code& distances) {
    for (int symbol = literals.next(bits_); symbol != 256; symbol = literals.next(bits_)) {
      if (symbol < 256) {
        put(static_cast<char>(symbol));
        continue;
      }
      const std::size_t length = length_of(symbol);
      repeat(length, distance_of(distances.next(bits_)));
    }
  }
  std::size_t length_of(int symbol) {
    require(symbol <= 285, "a length that there is not");
    if (symbol == 285) return 258;
    const int extra = symbol < 265 ? 0 : (symbol - 261) / 4;
    const int start = symbol < 265 ? symbol - 254 : 3 + ((4 + (symbol - 261) % 4) << extra);
    return static_cast<std::size_t>(start) + bits_.take(extra);
  }
  std::size_t distance_of(int symbol) {
    require(symbol <= 29, "a distance that there is not");
    const int extra = symbol < 2 ? 0 : symbol / 2 - 1;
    const int start = symbol < 2 ? 1 + symbol : 1 + ((2 + symbol % 2) << extra);
    return static_cast<std::size_t>(start) + bits_.take(extra);
  }
  void repeat(std::size_t length, std::size_t distance) {
    require(distance <= std::min(out.size(), window_), "a distance beyond the start");
    for (std::size_t i = 0; i < length; ++i) put(out[out.size() - distance]);
  }

  Bits bits_;
  std::size_t window_, most_;
};

// RFC 1950, 8.2.
std::uint32_t adler(std::string_view bytes) {
  std::uint32_t low = 1, high = 0;
  for (const char byte : bytes) {
    low = (low + static_cast<std::uint8_t>(byte)) % 65521;
    high = (high + low) % 65521;
  }
  return high << 16U | low;
}

}  // namespace

std::string inflated(std::string_view stream, std::size_t most) {
  require(stream.size() >= 2, "no zlib stream");
  const auto method = static_cast<std::uint8_t>(stream[0]),
             flags = static_cast<std::uint8_t>(stream[1]);
  require((method & 15U) == 8 && method >> 4U <= 7, "a zlib stream of an unknown method");
  require((256U * method + flags) % 31 == 0, "a zlib header whose sum is wrong");
  require((flags & 32U) == 0, "a zlib stream with a dictionary");
  Inflater inflater(stream.substr(2), std::size_t{256} << (method >> 4U), most);
  const std::string_view sum = inflater.run();
  require(sum.size() == 4, "a zlib stream that does not end with its sum");
  std::uint32_t stated = 0;
  for (const char byte : sum) stated = stated << 8U | static_cast<std::uint8_t>(byte);
  require(stated == adler(inflater.out), "a zlib stream whose sum is wrong");
  return std::move(inflater.out);
}

}  // namespace tia::test
