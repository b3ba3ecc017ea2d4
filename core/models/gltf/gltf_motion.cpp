#include <algorithm>
#include <functional>
#include <tuple>

#include "core/models/gltf/gltf_attributes.h"
#include "core/models/gltf/gltf_bytes.h"
#include "core/models/gltf/gltf_skins.h"

namespace tia::gltf {
namespace {

constexpr Formats animated_units =
    any_of({floats, format(Component::signed_byte, true), format(Component::unsigned_byte, true),
            format(Component::signed_short, true), format(Component::unsigned_short, true)});

// By AnimatedPath.
constexpr std::array<std::string_view, 4> path_names{"translation", "rotation", "scale", "weights"};
constexpr std::array<AccessorRule, 4> path_rules{{{only(ElementType::vec3), floats},
                                                  {only(ElementType::vec4), animated_units},
                                                  {only(ElementType::vec3), floats},
                                                  {only(ElementType::scalar), animated_units}}};
// By Interpolation.
constexpr std::array<std::string_view, 3> interpolation_names{"LINEAR", "STEP", "CUBICSPLINE"};

template <std::size_t n>
std::optional<std::size_t> place_in(const std::array<std::string_view, n>& names,
                                    std::string_view name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

/// Sampler: of an animation, before its numbers are read. Null: not to be used, which is a fault.
struct Sampler {
  const Accessor *input = nullptr, *output = nullptr;
  Interpolation interpolation = Interpolation::linear;

  std::uint64_t values_a_time() const {
    return interpolation == Interpolation::cubic_spline ? 3 : 1;
  }
};

const Accessor* sampler_accessor(const GltfSource& source, const GltfObject& object,
                                 std::string_view name, const AccessorRule& rule) {
  object.needs(name, "the number of an accessor");
  const Accessor* accessor = accessor_for(source, object, name, rule);
  if (accessor == nullptr || !accessor->strided) return accessor;
  object.fault(FaultKind::conflict, name, std::nullopt, "a view without a byteStride");
  return nullptr;
}

Sampler read_sampler(const GltfSource& source, const GltfObject& object) {
  Sampler sampler;
  sampler.input = sampler_accessor(source, object, "input", {only(ElementType::scalar), floats});
  sampler.output = sampler_accessor(source, object, "output", {0xFF, 0xFFFF});
  const std::size_t before = source.faults.count();
  const std::string name = object.text("interpolation");
  const auto place = place_in(interpolation_names, name);
  if (place) sampler.interpolation = static_cast<Interpolation>(*place);
  else if (object.has("interpolation") && source.faults.count() == before)
    object.fault(FaultKind::out_of_range, "interpolation", excerpt(name),
                 listed({interpolation_names.begin(), interpolation_names.end()}));
  if (sampler.input != nullptr && sampler.input->count < 2 &&
      sampler.interpolation == Interpolation::cubic_spline)
    object.fault(FaultKind::out_of_range, "input", Value("1 time"), "two times or more");
  return sampler;
}

/// AnimationReader: reads one animation after the other, and counts their numbers in all: many
/// channels may share a sampler, and each gets what it has.
class AnimationReader {
 public:
  AnimationReader(const GltfSource& source, Model& model)
      : source_(source),
        model_(model),
        nodes_(source.root.size_of("nodes")),
        numbers_left_(source.limits.vertices) {}

  void read(const GltfObject& object) {
    ModelAnimation animation;
    animation.name = object.text("name");
    object.needs("channels", "a list of channels");
    object.needs("samplers", "a list of samplers");
    samplers_.clear();
    places_.clear();
    object.for_each("samplers", [&](const GltfObject& sampler, std::size_t) {
      samplers_.push_back(read_sampler(source_, sampler));
    });
    if (samplers_.empty()) return;
    const Place samplers = object.at().at("samplers");
    object.for_each("channels", [&](const GltfObject& channel, std::size_t number) {
      AnimationChannel read;
      if (!read_target(channel, read)) return;
      places_.push_back({read.node, read.path, number});
      channel.needs("sampler", "the number of a sampler");
      const MaybeIndex sampler = channel.index("sampler", samplers_.size());
      if (sampler && read_numbers(channel, samplers_[*sampler], samplers.at(*sampler), read))
        animation.channels.push_back(std::move(read));
    });
    refuse_twice(object.at().at("channels"));
    model_.animations.push_back(std::move(animation));
  }

 private:
  struct Target {
    ModelIndex node;
    AnimatedPath path;
    std::size_t channel;
  };

  // Which node and what of it; false where nothing of Tia's is meant.
  bool read_target(const GltfObject& channel, AnimationChannel& read) {
    bool good = false;
    channel.needs("target", "an object with a node and a path");
    channel.with("target", [&](const GltfObject& target) {
      if (!target.needs("path", listed({path_names.begin(), path_names.end()}))) return;
      const std::string name = target.text("path");
      const auto path = place_in(path_names, name);
      const MaybeIndex node = target.index("node", nodes_);
      if (!path)
        model_.warn({target.at().at("path").pointer(), 0, excerpt_of(name, 64) + " is not taken"});
      if (!path || !node || *node >= model_.nodes.size()) return;
      read.node = *node;
      read.path = static_cast<AnimatedPath>(*path);
      good = can_move(target, read);
    });
    return good;
  }

  bool can_move(const GltfObject& target, const AnimationChannel& channel) const {
    const bool weights = channel.path == AnimatedPath::weights;
    if (!weights && model_.nodes[channel.node].matrix)
      target.fault(FaultKind::conflict, std::nullopt, "a node without a matrix");
    else if (weights && targets_of(channel.node) == 0)
      target.fault(FaultKind::conflict, std::nullopt, "a node whose mesh has morph targets");
    else return true;
    return false;
  }

  std::size_t targets_of(ModelIndex node) const {
    const MaybeIndex mesh = model_.nodes[node].mesh;
    return mesh && *mesh < model_.meshes.size() ? model_.meshes[*mesh].weights.size() : 0;
  }

  bool read_numbers(const GltfObject& channel, const Sampler& sampler, const Place& place,
                    AnimationChannel& read) {
    if (sampler.input == nullptr || sampler.output == nullptr) return false;
    read.interpolation = sampler.interpolation;
    if (!outputs_fit(channel, sampler, read) || !take(channel, sampler)) return false;
    auto times = read_elements<float>(source_, *sampler.input, sampler.input->count, farthest);
    auto values = read_elements<float>(source_, *sampler.output, sampler.output->count, farthest);
    if (!times || !values || !times_ascend(*times, place.at("input"))) return false;
    read.times = std::move(*times);
    read.values = std::move(*values);
    return read.path != AnimatedPath::rotation || all_turn(channel, read);
  }

  // Whether there are as many values as times.
  bool outputs_fit(const GltfObject& channel, const Sampler& sampler,
                   const AnimationChannel& read) const {
    const AccessorRule& rule = path_rules[static_cast<std::size_t>(read.path)];
    if (!fits(*sampler.output, rule)) {
      channel.fault(FaultKind::wrong_type, "sampler", Value(words(*sampler.output)), words(rule));
      return false;
    }
    std::uint64_t each = sampler.values_a_time();
    if (read.path == AnimatedPath::weights) each *= targets_of(read.node);
    const std::uint64_t count = sampler.output->count;
    if (each > 0 && count % each == 0 && count / each == sampler.input->count) return true;
    channel.fault(FaultKind::conflict, "sampler",
                  Value(std::to_string(count) + " values for " +
                        std::to_string(sampler.input->count) + " times"),
                  std::to_string(each) + " for each time");
    return false;
  }

  bool take(const GltfObject& channel, const Sampler& sampler) {
    const std::uint64_t size = sampler.output->layout.numbers();
    const bool fit = sampler.input->count <= numbers_left_ &&
                     sampler.output->count <= (numbers_left_ - sampler.input->count) / size;
    if (fit) numbers_left_ -= sampler.input->count + sampler.output->count * size;
    else
      channel.fault(FaultKind::limit, std::nullopt,
                    "at most " + std::to_string(source_.limits.vertices) +
                        " numbers of all animations, a shared sampler's for each channel");
    return fit;
  }

  bool times_ascend(const std::vector<float>& times, const Place& at) {
    const auto wrong = std::ranges::adjacent_find(times, std::ranges::greater_equal());
    if (times.front() >= 0 && wrong == times.end()) return true;
    if (!source_.faults.at(at.pointer()))  // of an earlier channel with the same sampler
      source_.faults.add({FaultKind::out_of_range, at.pointer(),
                          Value(double{times.front() < 0 ? times.front() : *(wrong + 1)}),
                          "times from 0 on that ascend"});
    return false;
  }

  // A quaternion without a length turns nothing anywhere.
  bool all_turn(const GltfObject& channel, const AnimationChannel& read) {
    const bool spline = read.interpolation == Interpolation::cubic_spline;
    for (std::size_t i = spline ? 4 : 0; i < read.values.size(); i += spline ? 12 : 4) {
      const float* q = read.values.data() + i;
      if (q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0) continue;
      channel.fault(FaultKind::out_of_range, "sampler", std::nullopt,
                    "quaternions that are not zero");
      return false;
    }
    return true;
  }

  void refuse_twice(const Place& channels) {
    std::ranges::sort(places_, {}, [](const Target& target) {
      return std::tuple(target.node, target.path, target.channel);
    });
    for (std::size_t i = 1; i < places_.size() && !source_.faults.full(); ++i) {
      const Target &one = places_[i - 1], &other = places_[i];
      if (one.node == other.node && one.path == other.path)
        source_.faults.add({FaultKind::conflict, channels.at(other.channel).at("target").pointer(),
                            std::nullopt,
                            "each path of a node in one channel: channel " +
                                std::to_string(one.channel) + " has this one"});
    }
  }

  const GltfSource& source_;
  Model& model_;
  std::size_t nodes_;
  std::uint64_t numbers_left_;
  std::vector<Sampler> samplers_;
  std::vector<Target> places_;
};

}  // namespace

void read_motion(const GltfSource& source, Model& model) {
  read_skins(source, model);
  AnimationReader reader(source, model);
  source.root.for_each("animations",
                       [&](const GltfObject& object, std::size_t) { reader.read(object); });
}

}  // namespace tia::gltf
