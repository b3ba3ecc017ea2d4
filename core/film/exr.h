// OpenEXR out: planes of numbers with names, in half, float or whole numbers.
//
// Not by its library: that is five shared libraries (4.8 MB), whose bytes would depend on zlib's
// version and which compresses on one thread here; and Debian's cannot be there for two processors
// at once. Its programs read ours in the tests.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/film/planes.h"
#include "core/parallel/workers.h"

namespace tia {

/// How the numbers of a channel are stored; the values are the format's own.
enum class ExrType { uint = 0, half = 1, real = 2 };

/// ExrChannel: a plane by its name.
struct ExrChannel {
  std::string name;
  ExrType type = ExrType::real;
  int plane = 0;
};

/// ExrHead: what the file says of the planes.
struct ExrHead {
  int width = 0, height = 0;  ///< of the whole picture, the display window
  int x0 = 0, y0 = 0;         ///< where the planes begin in it, the data window's corner
  std::vector<ExrChannel> channels;
  std::vector<std::pair<std::string, std::string>> texts;  ///< attributes
};

/// Returns: a file of one part: scan lines from the top, 16 a block, compressed as "ZIP". Same
/// numbers, same bytes, whoever works. Domain: names of 1 to 31 bytes; whole numbers from 0 to 2^24
/// in planes of `uint`; blocks below 2 GiB. Errors: Stopped; std::bad_alloc.
/// Source: F. Kainz, R. Bogart et al., "OpenEXR File Layout", openexr.com; ZIP's order of bytes by
/// its ImfZip.cpp.
std::string encode_exr(ExrHead head, const Planes& planes, const Workers& workers);

}  // namespace tia
