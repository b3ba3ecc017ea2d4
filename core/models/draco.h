// Draco in: libdraco's decoder behind bounds. What it unpacks are integers; what floats they stand
// for is computed here, for a library compiled for another processor may round otherwise.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/models/model_files.h"

namespace draco {
class Mesh;
class PointAttribute;
}  // namespace draco

namespace tia {

/// DracoMesh: triangles that Draco has packed.
class DracoMesh {
 public:
  /// Returns: none, and why in words, of what is not a whole mesh with vertices that are there.
  /// Errors: std::bad_alloc. Cost: memory and time as the packed bytes say, which a few of them may
  /// say much: for a process that may take little.
  /// Source: Draco Bitstream Specification 2.2 (2017), as libdraco 1.5.5 reads it.
  static std::optional<DracoMesh> unpack(ModelBytes packed, std::string& why);

  std::uint64_t vertices() const;
  std::vector<std::uint32_t> indices() const;  ///< three a triangle, all of them vertices
  /// How many numbers a vertex has of the attribute of that id; 0: there is none.
  std::size_t numbers(std::uint32_t id) const;
  /// The numbers of all vertices, one after the other. None where the attribute has others than
  /// Number holds. Domain: an attribute that is there; Number: float or an integer of up to 32
  /// bits.
  template <class Number>
  std::optional<std::vector<Number>> values(std::uint32_t id) const;

 private:
  explicit DracoMesh(std::shared_ptr<const draco::Mesh> mesh) : mesh_(std::move(mesh)) {}
  const draco::PointAttribute* attribute(std::uint32_t id) const;

  std::shared_ptr<const draco::Mesh> mesh_;
};

}  // namespace tia
