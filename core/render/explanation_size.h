// How many bytes an explanation takes as JSON, counted before any of it is made.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/accel/world/all_hits.h"
#include "core/integrators/ray_tree.h"
#include "core/scene/labels.h"

namespace tia {

struct PathRecord;

/// The longest explanation, in bytes of its JSON.
inline constexpr std::size_t longest_explanation = 4 << 20;

/// ExplanationSize: takes what is told in turn and counts the most that it can be.
/// Errors: InputError (limit) where it would be more than longest_explanation.
class ExplanationSize {
 public:
  /// Of the world's objects. Both outlive it.
  ExplanationSize(const World& world, const std::vector<ObjectLabel>& labels)
      : world_(world), labels_(labels) {}

  void hit(const Meeting& at);
  void ray(const Hit<float>& hit);
  void term(TermName name, const LightRecord& record);
  /// Domain: a path of that world, of the same objects.
  void path(const PathRecord& path, const World& world);
  void path_group();
  void path_surface(int object);
  void note(std::string_view pointer, std::string_view about);

  std::size_t bytes() const { return bytes_; }
  /// The numbers of all objects that are told of.
  const std::set<int>& objects() const { return objects_; }

 private:
  void take(std::size_t bytes, const char* pointer, const char* remedy);
  // Of the member that names a primitive's object, and, the first time, of the object's entry.
  std::size_t naming(int primitive) { return naming(primitive, world_); }
  std::size_t naming(int primitive, const World& world);
  std::size_t naming_object(int object, std::size_t copy_bytes);
  void take_of_path(std::size_t bytes);

  const World& world_;
  const std::vector<ObjectLabel>& labels_;
  std::set<int> objects_{};
  std::size_t bytes_ = 1024;  // pixel, sample, ray, the frame of all
};

}  // namespace tia
