// What the steps of a request may take of memory at most, by measurement: one table, by which they
// claim it beforehand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tia::server {

/// MemoryCost: a row of the table: so many bytes for each unit that the step is given.
struct MemoryCost {
  std::string_view step, unit;
  std::int64_t bytes = 0;
  std::string_view about;
};

namespace memory_cost {

inline constexpr MemoryCost text{"text", "byte of JSON text", 40,
                                 "its tree, and the scene that is read from it"};
inline constexpr MemoryCost value{"value", "JSON value, as many as may be in so long a text", 400,
                                  "the same, where the text says much in few bytes"};
inline constexpr MemoryCost patch{"patch", "byte of a scene in memory", 8,
                                  "the scene written as a tree, patched, and read again"};
inline constexpr MemoryCost build{"build", "byte of what the objects say", 12,
                                  "the index over them, while it is built"};
inline constexpr MemoryCost png{"png", "pixel", 13,
                                "its codes, filtered and packed, and the file with its recipe"};
inline constexpr MemoryCost alpha{"alpha", "pixel", 18, "the same of one with alpha"};
inline constexpr MemoryCost linear{"linear", "pixel", 26, "its light in floats, and the file"};
inline constexpr MemoryCost layers{"layers", "number of a layer", 18,
                                   "it in floats, the sum over its samples, and the file"};
inline constexpr MemoryCost rounds{"rounds", "pixel of a picture with a budget, or a stream", 160,
                                   "the sums over its samples, and what it was a round ago"};
inline constexpr MemoryCost denoise{"denoise", "pixel that is denoised, and of the room around",
                                    320,
                                    "its half buffers, what is fitted to them, and what that says"};
inline constexpr MemoryCost denoise_thread{"denoise_thread", "thread that denoises", 1 << 20,
                                           "the weights and the fits of a tile"};
inline constexpr MemoryCost gaze{"gaze", "ray of a picture for a gaze", 96,
                                 "where it goes, what it finds, and the pixels near the fovea"};
inline constexpr MemoryCost encoder{"encoder", "film as webm or webp", 16 << 20,
                                    "what its encoder has however small the frames are"};
inline constexpr MemoryCost webm{"webm", "pixel of a film's frame", 84,
                                 "what VP9's encoder keeps from frame to frame, and the planes"};
inline constexpr MemoryCost webp{"webp", "pixel of a film's frame", 60,
                                 "what the encoder keeps from frame to frame, and searches in"};
inline constexpr MemoryCost model{"model", "byte of a model's files", 4,
                                  "what its reader answers, and what that comes to"};
inline constexpr MemoryCost request{"request", "request", 1 << 20, "all else"};

}  // namespace memory_cost

/// All rows.
std::span<const MemoryCost> memory_costs();

/// Of a text of JSON with at most so many values: the larger of the two rows. Space/units: bytes.
std::int64_t memory_for_text(std::size_t bytes, std::size_t most_values);

/// Space/units: bytes.
inline std::int64_t memory_for(const MemoryCost& cost, std::size_t count) {
  return cost.bytes * static_cast<std::int64_t>(count);
}

}  // namespace tia::server
