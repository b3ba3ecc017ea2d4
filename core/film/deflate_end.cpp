#include "core/film/deflate_end.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>

namespace tia {
namespace {

[[noreturn]] void refuse() { throw std::invalid_argument("no deflate stream"); }

/// Bits: the stream, of which at least 56 bits wait in a register once they are asked for.
/// Source: F. Giesen, "Reading bits in far too many ways (part 2)", 2018, variant 4.
class Bits {
 public:
  Bits(const std::uint8_t* data, std::size_t bytes) : data_(data), bytes_(bytes) {}
  static constexpr std::size_t waiting = 56;

  std::uint64_t peek() {
    if (next_ >= bytes_ + 8) refuse();
    std::uint64_t more = 0;
    for (std::size_t i = 0; i < 8; ++i)
      more |= static_cast<std::uint64_t>(data_[next_ + i]) << 8 * i;
    waiting_ |= more << count_;
    next_ += (63 - count_) / 8;
    count_ |= waiting;
    return waiting_;
  }
  /// Domain: no more than wait. Returns: those behind.
  std::uint64_t skip(std::size_t bits) {
    count_ -= bits;
    return waiting_ >>= bits;
  }
  std::size_t take(std::size_t bits) {
    const std::uint64_t taken = peek() & ((std::uint64_t{1} << bits) - 1);
    skip(bits);
    return taken;
  }
  void skip_to_byte() { skip(count_ % 8); }
  void skip_bytes(std::size_t bytes) {  // from a byte's first bit on
    next_ += bytes - count_ / 8;
    waiting_ = count_ = 0;
  }
  /// Errors: the stream's end lies before.
  std::size_t position() const {
    const std::size_t position = 8 * next_ - count_;
    if (position > 8 * bytes_) refuse();
    return position;
  }

 private:
  const std::uint8_t* data_;
  std::size_t bytes_, next_ = 0, count_ = 0;
  std::uint64_t waiting_ = 0;
};

/// Code: a prefix code as a table over the next bits: of each symbol what `kept(symbol, length)`
/// says, which is not 0; 0 where no symbol begins.
class Code {
 public:
  static constexpr std::size_t longest = 15;

  template <class Kept>
  Code(std::span<const std::uint8_t> lengths, Kept kept) {
    const std::size_t width = std::max<std::size_t>(1, *std::ranges::max_element(lengths));
    mask_ = (std::size_t{1} << width) - 1;
    std::fill_n(table_.begin(), mask_ + 1, std::uint8_t{0});
    auto next = first_codes(lengths);
    for (std::size_t symbol = 0; symbol < lengths.size(); ++symbol) {
      const std::size_t length = lengths[symbol];
      if (length == 0) continue;
      const std::size_t step = std::size_t{1} << length;
      for (std::size_t i = reversed(next[length]++, length); i <= mask_; i += step)
        table_[i] = static_cast<std::uint8_t>(kept(symbol, length));
    }
  }
  std::size_t at(std::uint64_t bits) const { return table_[bits & mask_]; }

 private:
  using Codes = std::array<std::size_t, longest + 1>;
  // RFC 1951, 3.2.2, steps 1 and 2: codes of one length follow one another, after the shorter ones.
  static Codes first_codes(std::span<const std::uint8_t> lengths) {
    Codes count{}, next{};
    for (const std::uint8_t length : lengths) ++count[length];
    count[0] = 0;
    for (std::size_t n = 1; n <= longest; ++n) next[n] = 2 * (next[n - 1] + count[n - 1]);
    return next;
  }
  // Codes come highest bit first, all else lowest bit first.
  static std::size_t reversed(std::size_t code, std::size_t length) {
    std::size_t other = 0;
    for (std::size_t i = 0; i < length; ++i) other |= (code >> i & 1U) << (length - 1 - i);
    return other;
  }

  std::size_t mask_;
  std::array<std::uint8_t, std::size_t{1} << longest> table_;
};

// What is kept of a symbol or a distance: how many bits it takes with those that follow its code,
// at most 15 + 5 and 15 + 13, so that both wait at once; and what the symbol is, if no literal.
constexpr std::size_t bits_of = 0x3F, is_match = 0x40, is_end = 0x80;

// RFC 1951, 3.2.5: 0 .. 255 are literals, 256 ends the block, 257 .. 285 begin matches.
std::size_t kept_of_symbol(std::size_t symbol, std::size_t length) {
  if (symbol < 256) return length;
  if (symbol == 256) return length | is_end;
  const std::size_t i = symbol - 257;
  const std::size_t more = i < 8 || i == 28 ? 0 : i / 4 - 1;
  return (length + more) | is_match;
}
std::size_t kept_of_distance(std::size_t symbol, std::size_t length) {
  return length + (symbol < 4 ? 0 : symbol / 2 - 1);
}

void skip_symbols(Bits& in, std::span<const std::uint8_t> symbol_lengths,
                  std::span<const std::uint8_t> distance_lengths) {
  const Code symbols(symbol_lengths, kept_of_symbol);
  const Code distances(distance_lengths, kept_of_distance);
  for (;;) {
    const std::size_t kept = symbols.at(in.peek());
    if (kept == 0) refuse();
    const std::uint64_t next = in.skip(kept & bits_of);
    if ((kept & is_end) != 0) return;
    if ((kept & is_match) == 0) continue;
    const std::size_t distance = distances.at(next);
    if (distance == 0) refuse();
    in.skip(distance);
  }
}

void skip_stored(Bits& in) {
  in.skip_to_byte();
  const std::size_t bytes = in.take(16);
  if ((in.take(16) ^ bytes) != 0xFFFF) refuse();
  in.skip_bytes(bytes);
}

// RFC 1951, 3.2.6.
void skip_fixed(Bits& in) {
  std::array<std::uint8_t, 288> symbols;
  std::array<std::uint8_t, 30> distances;
  for (std::size_t i = 0; i < symbols.size(); ++i)
    symbols[i] = i < 144 ? 8 : i < 256 ? 9 : i < 280 ? 7 : 8;
  distances.fill(5);
  skip_symbols(in, symbols, distances);
}

// RFC 1951, 3.2.7: the code of the lengths.
Code code_of_lengths(Bits& in, std::size_t given) {
  constexpr std::array<std::uint8_t, 19> order{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                               11, 4,  12, 3, 13, 2, 14, 1, 15};
  std::array<std::uint8_t, order.size()> lengths{};
  for (std::size_t i = 0; i < given; ++i) lengths[order[i]] = static_cast<std::uint8_t>(in.take(3));
  return {lengths, [](std::size_t symbol, std::size_t length) { return symbol << 3U | length; }};
}

// The same: lengths one by one, by their code, whose 16, 17, 18 repeat one.
void read_lengths(Bits& in, const Code& code, std::span<std::uint8_t> lengths) {
  std::size_t filled = 0;
  while (filled < lengths.size()) {
    const std::size_t kept = code.at(in.peek()), symbol = kept >> 3U;
    if (kept == 0 || (symbol == 16 && filled == 0)) refuse();
    in.skip(kept & 7U);
    std::size_t length = symbol, times = 1;
    switch (symbol) {
      case 16:
        length = lengths[filled - 1];
        times = 3 + in.take(2);
        break;
      case 17:
        length = 0;
        times = 3 + in.take(3);
        break;
      case 18:
        length = 0;
        times = 11 + in.take(7);
        break;
      default: break;
    }
    if (times > lengths.size() - filled) refuse();
    for (; times > 0; --times) lengths[filled++] = static_cast<std::uint8_t>(length);
  }
}

void skip_dynamic(Bits& in) {
  const std::size_t symbols = in.take(5) + 257, distances = in.take(5) + 1;
  const Code code = code_of_lengths(in, in.take(4) + 4);
  std::array<std::uint8_t, 288 + 32> lengths;
  const std::span<std::uint8_t> all = std::span(lengths).first(symbols + distances);
  read_lengths(in, code, all);
  skip_symbols(in, all.first(symbols), all.subspan(symbols));
}

}  // namespace

DeflateEnd deflate_end(const std::uint8_t* stream, std::size_t bytes) {
  Bits in(stream, bytes);
  for (;;) {
    const std::size_t block = in.position();
    const bool last = in.take(1) != 0;
    switch (in.take(2)) {
      case 0: skip_stored(in); break;
      case 1: skip_fixed(in); break;
      case 2: skip_dynamic(in); break;
      default: refuse();
    }
    if (last) return {block, in.position()};
  }
}

}  // namespace tia
