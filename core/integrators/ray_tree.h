// The tree of a camera ray for /explain: every ray, and every term of the sums of their light.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/integrators/world_view.h"

namespace tia {

/// TermName: the terms of a ray's light; diffuse and specular come light by light.
enum class TermName {
  background,
  emission,
  ambient,
  diffuse,
  specular,
  reflection,
  refraction,
  straight
};
template <>
struct Names<TermName> {
  static constexpr std::array<std::string_view, 8> names{"background", "emission", "ambient",
                                                         "diffuse",    "specular", "reflection",
                                                         "refraction", "straight"};
};

/// LightRecord: a light as a point sees it. Direction and distance are those to its middle.
struct LightRecord {
  int light = -1;  ///< which of the world's; -1: none
  LightSample<float> middle{};
  float n_dot_l = 0;
  float visible = 0;  ///< the share of its samples that are seen; those below the horizon are not
  float fade = 1;
  std::optional<int>
      blocker{};  ///< the first primitive towards the middle that takes light, -1:
                  ///< none; nothing where all samples are seen or are below the horizon
  std::int64_t blocker_instance = 0;
};

struct RayNode;

/// Term: weight * value, as the picture adds it.
struct Term {
  TermName name = TermName::background;
  float weight = 1;
  Vec3f value{};
  LightRecord light{};
  std::unique_ptr<RayNode> node{};  ///< of a ray that follows
};

/// RayNode: one ray of the tree and what it met.
struct RayNode {
  Ray<float> ray{};
  int depth = 0;
  Hit<float> hit{};
  Vec3f point{}, normal{};
  std::vector<Term> terms{};
  Vec3f color{};                 ///< what it found: the sum of the terms
  Vec3f transmittance{1, 1, 1};  ///< what the medium that it came through has left of that
};

/// NoRecorder: records nothing, for pictures.
struct NoRecorder {
  static constexpr bool records = false;
  void begin(const auto&...) {}
  void term(const auto&...) {}
  void child(const auto&...) {}
  void end(const auto&...) {}
};

/// RayTreeLimit: is asked before a ray or a term is recorded, so that no tree becomes larger than
/// an answer may be. Errors: what these throw where there is no room for it.
struct RayTreeLimit {
  std::function<void(const Hit<float>&)> ray;
  std::function<void(TermName, const LightRecord&)> term;
};

/// RayTreeRecorder: records the terms of one camera ray and of the rays that follow from it. For
/// each ray it is called in the order begin, terms and children, end; a child's calls lie between
/// those of its parent. Errors: what the limit throws.
class RayTreeRecorder {
 public:
  static constexpr bool records = true;
  LightRecord light{};  ///< the light that the next terms belong to

  explicit RayTreeRecorder(const RayTreeLimit& limit) : limit_(limit) {}

  void begin(const Ray<float>& ray, int depth, const Hit<float>& hit, const Vec3f& point,
             const Vec3f& normal) {
    limit_.ray(hit);
    auto node = std::make_unique<RayNode>();
    *node = {.ray = ray, .depth = depth, .hit = hit, .point = point, .normal = normal};
    open_.push_back(std::move(node));
  }
  void term(TermName name, float weight, const Vec3f& value) {
    limit_.term(name, light);
    Term& term = open_.back()->terms.emplace_back();
    term.name = name;
    term.weight = weight;
    term.value = value;
    term.light = light;
  }
  /// Adds the ray that ended last as a term of its parent.
  void child(TermName name, float weight, const Vec3f& value) {
    term(name, weight, value);
    open_.back()->terms.back().node = std::move(ended_);
  }
  void end(const Vec3f& color, const Vec3f& transmittance) {
    ended_ = std::move(open_.back());
    open_.pop_back();
    ended_->color = color;
    ended_->transmittance = transmittance;
  }
  /// The ray that ended last; once all is traced, the camera ray.
  std::unique_ptr<RayNode> take() { return std::move(ended_); }

 private:
  const RayTreeLimit& limit_;
  std::vector<std::unique_ptr<RayNode>> open_;
  std::unique_ptr<RayNode> ended_;
};

}  // namespace tia
