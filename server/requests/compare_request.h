// The parameters of /compare, and what two pictures come to as a display shows them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/film/similarity.h"
#include "server/requests/plan.h"
#include "server/stores/picture.h"

namespace tia::server {

/// CompareRequest: two pictures, and where an eye looks.
struct CompareRequest {
  static constexpr std::string_view schema_name = "compare_request";
  std::optional<PictureRequest> a, b;  ///< once it has been read both are there
  std::optional<std::array<double, 2>> gaze;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using C = CompareRequest;
    visit(
        "a", &C::a,
        Spec{.about = "a picture, as POST /render takes it, of the format png", .required = true});
    visit("b", &C::b, Spec{.about = "another one of its size", .required = true});
    visit(
        "gaze", &C::gaze,
        Spec{.about = "x,y in the whole picture a: bands are told by how far they are from there; "
                      "else from the gaze of a or b, if there is one",
             .unit = "pixels",
             .min = -ViewRequest::most_px,
             .max = ViewRequest::most_px});
  }
  /// Formats other than PNG, what has no fixed number of rays.
  void check(const Place& at, Faults& faults) const;
  /// That or the pictures' own.
  std::optional<std::array<double, 2>> gaze_in_effect() const;
};

/// Its plan, of light in floats instead of a file. Errors: as plan_of, at `pointer`.
Plan light_plan_of(const PictureRequest& asked, const char* pointer, const RenderContext& context,
                   const Requester& requester);

/// What is shown of such a picture, in [0, 1], before it is rounded to codes. The picture is spent.
Image shown_signals(const Plan& plan, Picture&& picture, const Workers& workers);

/// Both held against each other: {"mse", "psnr_db", "ssim", "max", "bands"}.
Value compared(const CompareRequest& asked, const Plan& plan_a, const Image& a, const Image& b,
               const std::stop_token& stop);
Value comparison_schema(Definitions& named);

/// Does it. Errors: what it throws, InputError's pointers with that one before them.
template <class Work>
auto at_pointer(const char* pointer, const Work& work) {
  try {
    return work();
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer.insert(0, pointer);
    throw InputError(std::move(faults));
  }
}

}  // namespace tia::server
