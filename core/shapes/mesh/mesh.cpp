#include "core/shapes/mesh/mesh.h"

namespace tia {
namespace {

std::string count_text(std::size_t numbers) { return std::to_string(numbers) + " numbers"; }

void check_threes(std::size_t numbers, const Place& at, Faults& faults) {
  if (numbers % 3 != 0)
    faults.add({FaultKind::wrong_type, at.pointer(), Value(count_text(numbers)),
                "a multiple of 3 numbers"});
}

// A list that may be left out has `each` numbers a vertex.
void check_length(std::size_t numbers, std::size_t each, std::size_t vertices, const Place& at,
                  Faults& faults) {
  if (numbers != 0 && numbers != each * vertices)
    faults.add({FaultKind::wrong_type, at.pointer(), Value(count_text(numbers)),
                std::to_string(each) + " numbers for each of the " + std::to_string(vertices) +
                    " vertices, or none"});
}

void check_indices(const std::vector<std::uint32_t>& indices, std::size_t vertices, const Place& at,
                   Faults& faults) {
  for (std::size_t i = 0; i < indices.size() && !faults.full(); ++i) {
    if (indices[i] < vertices) continue;
    Fault fault{
        FaultKind::out_of_range, at.at(i).pointer(), {}, "the index of a position, from 0 to "};
    fault.got = write_value(indices[i]);
    fault.allowed += std::to_string(vertices - 1);
    faults.add(std::move(fault));
  }
}

}  // namespace

void Mesh::check(const Place& at, Faults& faults) const {
  check_threes(positions.values.size(), at.at("positions"), faults);
  check_threes(indices.values.size(), at.at("indices"), faults);
  if (triangles() > most_triangles)
    faults.add({FaultKind::limit, at.at("indices").pointer(),
                Value(count_text(indices.values.size())),
                "at most " + std::to_string(3 * most_triangles) + " numbers"});
  check_length(normals.values.size(), 3, vertices(), at.at("normals"), faults);
  check_length(uvs.values.size(), 2, vertices(), at.at("uvs"), faults);
  check_length(colors.values.size(), 4, vertices(), at.at("colors"), faults);

  check_indices(indices.values, vertices(), at.at("indices"), faults);
  const Place all_normals = at.at("normals");
  const auto& n = normals.values.get();
  for (std::size_t i = 0; i + 2 < n.size() && !faults.full(); i += 3) {
    const Vec3d normal{n[i], n[i + 1], n[i + 2]};
    if (dot(normal, normal) == 0)
      faults.add({FaultKind::out_of_range, all_normals.at(i).pointer(), write_value(normal),
                  "a normal of some length"});
  }
}

}  // namespace tia
