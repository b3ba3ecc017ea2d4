#include "core/scene/at_time.h"

#include <algorithm>
#include <array>

#include "core/scene/animation_absence.h"
#include "core/scene/animation_fields.h"
#include "core/scene/animation_track.h"

namespace tia {
namespace {

constexpr std::string_view key_light_place = "/key_light/position";
// Where each step of a target may lead to something that comes and goes.
constexpr std::array<std::string_view, 3> lists_of_visible{"objects", "children", "lights"};

/// Moved: a track and where its target is; no path where that is the key light's place.
struct Moved {
  std::size_t track;
  TargetPath path;
};

/// Resolution: one scene at one time.
class Resolution {
 public:
  Resolution(const Scene& scene, double seconds, const Place& at, const std::stop_token& stop)
      : scene_(scene),
        tracks_(scene.animation->tracks),
        seconds_(seconds),
        animation_(at.at("animation").pointer()),
        faults_(stop) {}

  Scene operator()(const Middles& middles) {
    find_targets();
    if (refuse_overlaps()) faults_.raise();
    absent_ = absent_at_that_time();
    for (const Moved& each : moved_) put(each);
    absent_.erase_from(written_);
    Scene plain = read_again();
    faults_.raise();
    for (std::size_t i = 0; i < tracks_.size(); ++i)
      if (is_key_light(i) && !absent_.has(key_light_path())) plain = lit(plain, i, middles);
    return plain;
  }

 private:
  std::string place_of(std::size_t track) const {
    return animation_ + "/tracks/" + std::to_string(track);
  }
  bool is_key_light(std::size_t track) const { return tracks_[track].target == key_light_place; }
  double time_of(std::size_t track) const {
    return own_time(*scene_.animation, tracks_[track], seconds_);
  }
  std::string when() const { return "at " + number_text(seconds_) + " s "; }

  // ---- targets ----

  void find_targets() {
    const std::vector<std::string_view> fields = movable_fields();
    std::vector<TargetPath> steps;
    for (std::size_t i = 0; i < tracks_.size() && !faults_.full(); ++i) {
      steps.push_back(steps_of(tracks_[i].target));
      if (is_key_light(i)) continue;
      const TargetPath& own = steps.back();
      if (!own.empty() && std::ranges::find(fields, own.front()) != fields.end())
        touched_.insert(own.front());
      else refuse_field(i, own, fields);
    }
    if (faults_.empty()) only_ = moved_objects(scene_.objects, tracks_, steps);
    written_ = written_fields(scene_, touched_, only_);
    for (std::size_t i = 0; i < steps.size() && !faults_.full(); ++i)
      if (!steps[i].empty() && (touched_.contains(steps[i].front()) || is_key_light(i)))
        find_target(i, steps[i]);
  }

  void refuse_field(std::size_t track, const TargetPath& steps,
                    const std::vector<std::string_view>& known) {
    const std::string first = steps.empty() ? tracks_[track].target : steps.front();
    faults_.add({FaultKind::unknown_name, place_of(track) + "/target", Value(tracks_[track].target),
                 "a JSON Pointer, / and one of " + listed(known) + ", and so on",
                 nearest_name(first, known)});
  }

  void find_target(std::size_t i, const TargetPath& steps) {
    if (is_key_light(i)) return moved_.push_back({i, key_light_path()});
    TargetPath path = found_target(steps, written_, place_of(i) + "/target", faults_);
    if (path.empty()) return;
    if (tracks_[i].visible && !may_come_and_go(path))
      return faults_.add({FaultKind::out_of_range, place_of(i) + "/target",
                          Value(tracks_[i].target), "with visible an object or a light of a list"});
    moved_.push_back({i, std::move(path)});
  }

  bool may_come_and_go(const TargetPath& path) {
    return path.size() >= 2 && value_in(written_, path) != nullptr &&
           std::ranges::find(lists_of_visible, path[path.size() - 2]) != lists_of_visible.end();
  }

  // Where the light is that a track on the key light's place moves.
  TargetPath key_light_path() const {
    if (scene_.key_light) return steps_of(key_light_place);
    const auto light = std::ranges::find_if(scene_.lights, &Light::movable);
    if (light == scene_.lights.end()) return steps_of(key_light_place);
    return {"lights", std::to_string(light - scene_.lights.begin()), "position"};
  }

  // Values on one target or one inside of the other; presence is another matter than values.
  // Returns: whether there are such.
  bool refuse_overlaps() {
    const std::size_t known = faults_.count();
    std::vector<const Moved*> sorted;
    for (const Moved& each : moved_) sorted.push_back(&each);
    std::ranges::stable_sort(sorted,
                             [](const Moved* a, const Moved* b) { return a->path < b->path; });
    const Moved* value = nullptr;
    const Moved* presence = nullptr;
    for (const Moved* each : sorted) {
      const bool visible = tracks_[each->track].visible.has_value();
      const Moved*& before = visible ? presence : value;
      if (before != nullptr &&
          (visible ? each->path == before->path : is_within(each->path, before->path)))
        refuse_twice(*each, *before);
      else before = each;
    }
    return faults_.count() > known;
  }

  void refuse_twice(const Moved& one, const Moved& other) {
    const auto [earlier, later] = std::minmax(one.track, other.track);
    faults_.add({FaultKind::conflict, place_of(later) + "/target", Value(tracks_[later].target),
                 "a place that no other track moves, nor what is around it or in it; track " +
                     std::to_string(earlier) + " moves " + tracks_[earlier].target});
  }

  // ---- values ----

  Absence absent_at_that_time() const {
    std::vector<TargetPath> paths;
    for (const Moved& each : moved_)
      if (tracks_[each.track].visible && !tracks_[each.track].is_visible(time_of(each.track)))
        paths.push_back(each.path);
    return Absence(std::move(paths));
  }

  void put(const Moved& moved) {
    if (tracks_[moved.track].visible || is_key_light(moved.track) || absent_.has(moved.path))
      return;
    if (auto value = value_of(moved)) put_at(written_, moved.path, std::move(*value));
  }

  std::optional<Value> value_of(const Moved& moved) {
    const Track& track = tracks_[moved.track];
    auto value = value_at(track, kind_of_target(moved.path), time_of(moved.track));
    if (!value)
      faults_.add({FaultKind::out_of_range, place_of(moved.track) + "/formula",
                   write_value(*track.formula), when() + "a finite number for " + track.target});
    return value;
  }

  // ---- the plain scene ----

  Scene read_again() {
    Scene plain = scene_;
    plain.animation.reset();
    Faults found(faults_.stop());
    read_fields(*written_.as<Value::Object>(), touched_, only_, found, plain);
    plain.check_links({}, found);
    for (const Fault& fault : found.list()) tell(fault);
    return plain;
  }

  // A fault of the plain scene as one of the track that has made it.
  void tell(const Fault& fault) {
    const TargetPath where = absent_.before(steps_of(fault.pointer));
    const auto made = std::ranges::find_if(moved_, [&](const Moved& each) {
      return is_within(where, each.path) || is_within(each.path, where);
    });
    std::string at = animation_;
    if (made != moved_.end())
      at = place_of(made->track) + (fault.kind == FaultKind::unknown_name ? "/target" : "");
    faults_.add({fault.kind, at, fault.got,
                 when() + "at " + pointer_of(where) + ": " + fault.allowed, fault.nearest});
  }

  Scene lit(const Scene& plain, std::size_t track, const Middles& middles) {
    const auto value = value_of({track, steps_of(key_light_place)});
    faults_.raise();
    Vec3d position;
    Faults found;
    read_value(*value, {}, Spec{.min = -1e9, .max = 1e9}, found, position);
    for (const Fault& fault : found.list())
      faults_.add({fault.kind, place_of(track), *value,
                   when() + "at " + std::string(key_light_place) + ": " + fault.allowed});
    faults_.raise();
    return with_light(plain, position, middles, place_of(track));
  }

  const Scene& scene_;
  const std::vector<Track>& tracks_;
  double seconds_;
  std::string animation_;  // a pointer
  Faults faults_;
  SceneFields touched_;
  MovedObjects only_;
  Value written_;
  std::vector<Moved> moved_;
  Absence absent_;
};

bool starts(const Animation& animation, std::string_view field) {
  return std::ranges::any_of(animation.tracks, [&](const Track& track) {
    const TargetPath steps = steps_of(track.target);
    return !steps.empty() && steps.front() == field;
  });
}

}  // namespace

bool moves_key_light(const Animation& animation) {
  return std::ranges::any_of(animation.tracks,
                             [](const Track& each) { return each.target == key_light_place; });
}

// By these a world is known: its objects, what they wear, and the light from everywhere.
bool moves_objects(const Animation& animation) {
  return starts(animation, "objects") || starts(animation, "materials") ||
         starts(animation, "ambient_light");
}

Scene at_time(const Scene& scene, double seconds, const Middles& middles, const Place& at,
              const std::stop_token& stop) {
  return Resolution(scene, seconds, at, stop)(middles);
}

}  // namespace tia
