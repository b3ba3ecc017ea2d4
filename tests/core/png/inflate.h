// Compressed bytes read by zlib, which shares nothing with the libdeflate that compresses ours.
#pragma once

#include <zlib.h>

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tia::test {

/// A whole zlib stream -> what it holds, at most so many bytes of it; its sum is checked.
/// Errors: std::runtime_error, bytes after its end included.
inline std::string inflated(std::string_view stream, std::size_t most) {
  std::string out(most, '\0');
  uLongf size = most;
  uLong taken = stream.size();
  const int result = uncompress2(reinterpret_cast<Bytef*>(out.data()), &size,
                                 reinterpret_cast<const Bytef*>(stream.data()), &taken);
  if (result != Z_OK) throw std::runtime_error(std::string("zlib: ") + zError(result));
  if (taken != stream.size()) throw std::runtime_error("bytes after the zlib stream");
  out.resize(size);
  return out;
}

}  // namespace tia::test
