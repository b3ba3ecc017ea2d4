#include "core/models/meshopt.h"

#include <meshoptimizer.h>

namespace tia {

bool unpack_meshopt(MeshoptMode mode, ModelBytes packed, std::size_t count, std::size_t stride,
                    std::span<std::uint8_t> to) {
  int (*decode)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t) =
      meshopt_decodeVertexBuffer;
  if (mode == MeshoptMode::triangles) decode = meshopt_decodeIndexBuffer;
  if (mode == MeshoptMode::indices) decode = meshopt_decodeIndexSequence;
  return decode(to.data(), count, stride, packed.data(), packed.size()) == 0;
}

}  // namespace tia
