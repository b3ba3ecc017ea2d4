// The parameters of /still.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>

#include "core/models/kept_model.h"
#include "core/models/paths.h"
#include "core/scene/still.h"
#include "server/contract/text_form.h"
#include "server/requests/render_request.h"

namespace tia::server {

/// What is answered: the still, or the scene that it is the picture of.
enum class StillAs { picture, scene };

}  // namespace tia::server

template <>
struct tia::Names<tia::server::StillAs> {
  static constexpr std::array<std::string_view, 2> names{"picture", "scene"};
};

namespace tia::server {

template <>
struct TextForm<Backdrop> {
  static Value read(std::string_view text, const Place&) {
    const Value number = number_from_text(text);
    return number.as<double>() != nullptr ? number : list_from_text(text);
  }
  static std::string allowed(const Spec& spec) {
    return "r,g,b, each " + range_text(spec, false) + ", or transparent";
  }
  static Value::Object in_query(Value::Object schema) { return list_in_query(std::move(schema)); }
};

/// What is written as a number is one.
template <>
struct TextForm<CameraChoice> {
  static Value read(std::string_view text, const Place&) { return number_from_text(text); }
  static std::string allowed(const Spec& spec) { return Codec<CameraChoice>::allowed(spec); }
  static Value::Object in_query(Value::Object schema) { return {{"schema", std::move(schema)}}; }
};

/// StillParameters: how a model is placed, how it is shown, and the picture of that.
struct StillParameters : PlacedModel, StillRequest, PictureRequest {
  static constexpr int side = 512;
  StillAs as = StillAs::picture;

  StillParameters() { width = height = side; }

  template <class Visitor>
  static void fields(Visitor&& visit);
  /// As a still's and a picture's own; and a format without alpha for what is transparent.
  void check(const Place& at, Faults& faults) const;
  IntegratorName integrator_in_effect() const { return integrator.value_or(IntegratorName::path); }
};

/// Whose a field of StillParameters is.
enum class StillPart { model, moment, view, other };
template <class Owner>
inline constexpr StillPart still_part = StillPart::other;
template <>
inline constexpr StillPart still_part<PlacedModel> = StillPart::model;
template <>
inline constexpr StillPart still_part<Moment> = StillPart::moment;
template <>
inline constexpr StillPart still_part<ViewRequest> = StillPart::view;

/// What a still's parameter means, by what it means elsewhere; nothing where a still has none.
std::optional<Spec> still_parameter(StillPart of, std::string_view name, const Spec& spec);

/// Visitor: hands fields on as StillParameters' own, for its defaults hold; but not all.
template <class Visitor>
struct StillFields {
  Visitor& visit;

  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*member, const Spec& spec) const {
    Member StillParameters::*const own = member;
    if (const auto as_told = still_parameter(still_part<Base>, name, spec))
      visit(name, own, *as_told);
  }
};

template <class Visitor>
void StillParameters::fields(Visitor&& visit) {
  const StillFields<std::remove_reference_t<Visitor>> own{visit};
  StillRequest::fields(own);
  PlacedModel::fields(own);
  PictureRequest::fields(own);
  visit("as", &StillParameters::as,
        Spec{.about = "scene: instead of the picture the scene of which POST /render draws it, "
                      "given the same width, height, crop and format"});
}

/// ShownStill: the same over HTTP, where it may be shown while it is drawn.
struct ShownStill : StillParameters {
  std::optional<Stream> stream;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    StillParameters::fields(visit);
    visit("stream", &ShownStill::stream, Spec{.about = "as of /render"});
  }
  /// As theirs; and a stream of what is not drawn.
  void check(const Place& at, Faults& faults) const;
};

/// StillQuery: the same of a model that is kept.
struct StillQuery : ShownStill {
  static constexpr std::string_view schema_name = "still_query";

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("model", &PlacedModel::id,
          Spec{.about = "a name of the gallery's models, or the id that POST /models has answered",
               .required = true,
               .max_bytes = longest_name});
    ShownStill::fields(visit);
  }
};

/// SentStillQuery: the same of a model that comes as the body.
struct SentStillQuery : ShownStill {
  static constexpr std::string_view schema_name = "sent_still_query";
  std::string main;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("main", &SentStillQuery::main,
          Spec{.about = "the path of the file that is the model, where several could be meant",
               .max_bytes = longest_path});
    ShownStill::fields(visit);
  }
};

/// The scene of the still of that model, with the options in effect; the model itself is told by
/// its id alone. Errors: InputError at the parameters: what they ask for and the model does not
/// have; `missing` where they leave nothing of it to be seen; Stopped.
/// Cost: goes through all that the model shows.
Scene still_of(const StillParameters& asked, const SharedModel& model,
               const std::stop_token& stop = {});

/// TurnedStills: the views of a turntable as scenes of their own, which differ in camera and
/// lights.
struct TurnedStills {
  Scene first;
  std::vector<SheetView> views;
  Scene at(int n) const;
};
/// As many as that, each the view that still_of's sheet of as many has. Errors: as still_of.
TurnedStills turned_stills_of(StillParameters asked, const SharedModel& model, int views,
                              const std::stop_token& stop = {});

}  // namespace tia::server
