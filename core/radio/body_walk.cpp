#include "core/radio/body_walk.h"

#include <set>

#include "core/radio/facet_builder.h"
#include "core/scene/labels.h"

namespace tia {
namespace {

constexpr double usual_thickness = 0.1;  // metres

/// BodyWalk: visits a scene's objects in the order of the world's numbers.
class BodyWalk {
 public:
  BodyWalk(const Scene& scene, const Wave& wave, RadioBodies& into)
      : scene_(scene), wave_(wave), labels_(object_labels(scene)), into_(into), facets_(into) {}

  void operator()() {
    through(scene_.objects, {Affine{}}, nullptr);
    say("without a radio material, concrete: ", no_material_);
    say("without a thickness, 0.1 m: ", no_thickness_);
    into_.warnings.assign(warnings_.begin(), warnings_.end());
  }

 private:
  using Places = std::vector<Affine>;  // of the copies

  void through(const std::vector<Object>& list, const Places& above, const Material* inherited) {
    for (const Object& object : list) {
      const Material* material = object.material ? &material_of(*object.material) : inherited;
      Places places;
      for (const Affine& each : above) places.push_back(each * object.transform.affine());
      if (is_many(object)) through(*children_of(object), copies(object, places), material);
      else add(object, places, material);
    }
  }
  static Places copies(const Object& object, const Places& places) {
    const auto* group = std::get_if<Group>(&object.shape);
    if (group == nullptr || !group->repeat) return places;
    const Repeat& repeat = *group->repeat;
    if (repeat.copies() > static_cast<std::int64_t>(RadioBodies::most_facets / places.size()))
      throw InputError({FaultKind::limit, "/scene", std::nullopt,
                        "copies of at most " + std::to_string(RadioBodies::most_facets)});
    Places all;
    for (const Affine& each : places)
      for (int k = 0; k < repeat.count[2]; ++k)
        for (int j = 0; j < repeat.count[1]; ++j)
          for (int i = 0; i < repeat.count[0]; ++i)
            all.push_back(each * Affine::translation(repeat.offset(i, j, k)));
    return all;
  }
  const Material& material_of(const MaterialRef& ref) const {
    if (const auto* own = std::get_if<Boxed<Material>>(&ref)) return **own;
    return scene_.materials.at(std::get<std::string>(ref));
  }

  void add(const Object& object, const Places& places, const Material* material) {
    const auto number = static_cast<int>(into_.bodies.size());
    const ObjectLabel& label = labels_[static_cast<std::size_t>(number)];
    RadioBody body{label.name, label.type};
    const bool said = material != nullptr && material->radio;
    const RadioMaterial radio = said ? *material->radio : RadioMaterial{};
    body.matter = matter_of(radio, wave_);
    const bool closed = is_closed(object.shape);
    const bool half_space = std::holds_alternative<Plane>(object.shape);
    body.sheet = !closed || (half_space && body.matter.thickness);
    body.thickness = body.matter.thickness.value_or(usual_thickness);
    if (!said) no_material_.insert(body.name);
    if (body.sheet && !body.matter.thickness && body.matter.kind == RadioMatter::dielectric)
      no_thickness_.insert(body.name);
    if (const std::string warning = band_warning(radio, wave_); !warning.empty())
      warnings_.insert(warning);
    if (!body.is_air())
      for (const Affine& place : places)
        body.flat = facets_.add(object.shape, place, number, !body.sheet);
    into_.bodies.push_back(std::move(body));
  }

  void say(const std::string& what, const std::set<std::string>& names) {
    if (names.empty()) return;
    into_.assumed.push_back(what + listed({names.begin(), names.end()}));
  }

  const Scene& scene_;
  const Wave& wave_;
  const std::vector<ObjectLabel> labels_;
  RadioBodies& into_;
  FacetBuilder facets_;
  std::set<std::string> no_material_, no_thickness_, warnings_;
};

}  // namespace

RadioBodies radio_bodies_of(const Scene& scene, const Wave& wave) {
  RadioBodies all;
  BodyWalk(scene, wave, all)();
  return all;
}

}  // namespace tia
