#include "core/scene/animation.h"

#include <algorithm>
#include <cmath>

#include "core/formulas/parse.h"

namespace tia {
namespace {

constexpr std::size_t most_parts = 64;  // of a list that moves

// One for a number, as many as there are for a list of numbers, none for anything else.
std::size_t numbers_in(const Value& value) {
  if (value.as<double>() != nullptr) return 1;
  const auto* list = value.as<Value::Array>();
  if (list == nullptr || list->size() > most_parts) return 0;
  const auto is_number = [](const Value& each) { return each.as<double>() != nullptr; };
  return std::all_of(list->begin(), list->end(), is_number) ? list->size() : 0;
}

bool is_alike(const Value& a, const Value& b) {
  return (a.as<double>() == nullptr) == (b.as<double>() == nullptr) &&
         numbers_in(a) == numbers_in(b);
}

/// TrackKeyCheck: what is wrong with the keys of a track.
class TrackKeyCheck {
 public:
  TrackKeyCheck(const Track& track, const Place& at, Faults& faults)
      : track_(track), keys_(*track.keys), at_(at), faults_(faults) {}

  void operator()() {
    for (std::size_t i = 0; i < keys_.size() && !faults_.full(); ++i) {
      if (i > 0 && !(keys_[i].time > keys_[i - 1].time))
        faults_.add({FaultKind::out_of_range, at_.at(i).at(std::size_t{0}).pointer(),
                     Value(keys_[i].time),
                     "times that ascend; the key before is at " + number_text(keys_[i - 1].time)});
      if (track_.interpolation != KeyInterpolation::step) check_value(i, 1, *keys_[i].value);
      check_tangents(i);
    }
  }

 private:
  void check_value(std::size_t i, std::size_t part, const Value& value) {
    const Value& first = *keys_.front().value;
    if (numbers_in(value) > 0 && is_alike(value, first)) return;
    const bool alike = numbers_in(value) > 0;
    faults_.add({alike ? FaultKind::conflict : FaultKind::wrong_type, at_.at(i).at(part).pointer(),
                 excerpt(value),
                 alike ? "as many numbers in each key as in the first"
                       : "a number or a list of numbers; anything else with interpolation step"});
  }

  void check_tangents(std::size_t i) {
    const bool bezier = track_.interpolation == KeyInterpolation::bezier;
    const AnimationKey& key = keys_[i];
    if (bezier != key.before.has_value())
      return faults_.add({FaultKind::conflict, at_.at(i).pointer(), std::nullopt,
                          bezier ? "[t, value, in, out], with tangents, by bezier"
                                 : "[t, value] or [t, value, ease]; tangents by bezier"});
    if (!bezier) return;
    check_value(i, 2, **key.before);
    check_value(i, 3, **key.after);
  }

  const Track& track_;
  const std::vector<AnimationKey>& keys_;
  const Place& at_;
  Faults& faults_;
};

void check_time_formula(const Track& track, const Place& at, Faults& faults) {
  check_parameters(track.formula_names(), at.at("parameters"), faults);
  ProgramBuilder builder;
  const Place place = at.at("formula");
  for (std::size_t i = 0; i < track.formula->parts.size() && !faults.full(); ++i)
    read_formula(track.formula->parts[i], track.formula_names(),
                 track.formula->is_list ? place.at(i) : place, builder, faults);
}

void check_visible(const Track& track, const Place& at, Faults& faults) {
  for (std::size_t i = 0; i < track.visible->size() && !faults.full(); ++i) {
    const auto& [from, to] = (*track.visible)[i];
    if (from < to) continue;
    faults.add({FaultKind::out_of_range, at.at(i).pointer(), write_value((*track.visible)[i]),
                "[from, to], of which to is later"});
  }
}

}  // namespace

void Track::check(const Place& at, Faults& faults) const {
  const int ways = keys.has_value() + formula.has_value() + visible.has_value();
  if (ways == 0)
    return faults.add({FaultKind::missing, at.pointer(), std::nullopt, "keys, formula or visible"});
  if (ways > 1)
    return faults.add(
        {FaultKind::conflict, at.pointer(), std::nullopt, "one of keys, formula and visible"});
  const auto only = [&](const char* name, bool given, bool with, const char* what) {
    if (given && !with)
      faults.add({FaultKind::conflict, at.at(name).pointer(), std::nullopt, what});
  };
  only("interpolation", interpolation != KeyInterpolation::linear, keys.has_value(), "with keys");
  only("repeat", repeat != KeyRepeat::once, keys.has_value(), "with keys");
  only("parameters", !parameters.empty(), formula.has_value(), "with a formula");
  if (keys) {
    const Place place = at.at("keys");
    TrackKeyCheck(*this, place, faults)();
  }
  if (formula) check_time_formula(*this, at, faults);
  if (visible) check_visible(*this, at.at("visible"), faults);
}

bool Track::is_visible(double seconds) const {
  return std::any_of(visible->begin(), visible->end(), [&](const auto& interval) {
    return interval[0] <= seconds && seconds < interval[1];
  });
}

void Animation::check(const Place& at, Faults& faults) const {
  if (duration * fps > most_frames)
    faults.add({FaultKind::limit, at.at("duration").pointer(), Value(duration),
                "at most " + number_text(most_frames) + " frames, duration times fps"});
}

int Animation::frames() const { return std::max(1, static_cast<int>(std::ceil(duration * fps))); }

// ---- JSON -----------------------------------------------------------------------------------

void Codec<AnimationKey>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                               AnimationKey& out) {
  const auto* list = v.as<Value::Array>();
  if (list == nullptr || list->size() < 2 || list->size() > 4)
    return detail::wrong_type(v, at, allowed(spec), faults);
  read_value((*list)[0], at.at(std::size_t{0}), spec, faults, out.time);
  out.value = (*list)[1];
  if (list->size() == 3) read_value((*list)[2], at.at(2), spec, faults, out.ease);
  if (list->size() == 4) {
    out.before = (*list)[2];
    out.after = (*list)[3];
  }
}

Value Codec<AnimationKey>::write(const AnimationKey& key) {
  Value::Array list{key.time, *key.value};
  if (key.ease != Ease::none) list.push_back(write_value(key.ease));
  if (key.before) {
    list.push_back(**key.before);
    list.push_back(**key.after);
  }
  return list;
}

Value Codec<AnimationKey>::schema(const Spec& spec, Definitions& named) {
  const Value time = schema_of<double>(spec, named), any = Value::Object{};
  const auto list = [](Value::Array parts) {
    const auto count = static_cast<double>(parts.size());
    return Value::Object{{"type", "array"},
                         {"prefixItems", std::move(parts)},
                         {"minItems", count},
                         {"maxItems", count}};
  };
  return Value::Object{
      {"oneOf", Value::Array{list({time, any}), list({time, any, schema_of<Ease>({}, named)}),
                             list({time, any, any, any})}}};
}

std::string Codec<AnimationKey>::allowed(const Spec&) {
  return "[t, value], [t, value, ease] or, of bezier, [t, value, in, out]";
}

void Codec<TimeFormula>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                              TimeFormula& out) {
  if (const auto* text = v.as<std::string>()) {
    out = {{*text}, false};
    return;
  }
  const auto* list = v.as<Value::Array>();
  if (list == nullptr || list->empty() || list->size() > most_parts)
    return detail::wrong_type(v, at, allowed(spec), faults);
  out = {{}, true};
  read_value(v, at, spec, faults, out.parts);
}

Value Codec<TimeFormula>::write(const TimeFormula& formula) {
  return formula.is_list ? write_value(formula.parts) : Value(formula.parts.front());
}

Value Codec<TimeFormula>::schema(const Spec& spec, Definitions& named) {
  Value::Object list = *schema_of<std::vector<std::string>>(spec, named).as<Value::Object>();
  list.emplace_back("minItems", 1);
  list.emplace_back("maxItems", static_cast<double>(most_parts));
  return Value::Object{{"oneOf", Value::Array{schema_of<std::string>(spec, named), list}}};
}

std::string Codec<TimeFormula>::allowed(const Spec&) {
  return "a formula, or a list of 1 to " + std::to_string(most_parts);
}

}  // namespace tia
