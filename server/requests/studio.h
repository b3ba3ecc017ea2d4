// Where pictures are drawn: a plan, its world, the films that tiles go to, the file.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <vector>

#include "server/operation/timing.h"
#include "server/requests/exr_picture.h"
#include "server/requests/onlooker.h"
#include "server/requests/plan.h"
#include "server/requests/render_context.h"
#include "server/stores/picture.h"

namespace tia::server {

/// Studio: where a plan's picture is drawn once, and others of it on the way there.
class Studio {
 public:
  /// All of them outlive it. Without an onlooker nothing else is drawn.
  Studio(const Plan& plan, const RenderContext& context, const std::stop_token& stop,
         const Onlooker* onlooker);

  using Worlds = std::vector<World>;  // of the exposure's scenes
  using CompileWorlds = std::function<Worlds(const Workers&)>;
  /// The picture, of the worlds that are compiled for it. Errors: as draw().
  Picture picture(const CompileWorlds& compile_worlds);

 private:
  void draw_on_a_film(const Worlds& worlds, Picture& picture);
  template <class Film>
  void draw_on(Film film, const Worlds& worlds, Picture& picture);
  template <class Film>
  void trace(Film& film, const Worlds& worlds, Picture& picture);
  void draw_features(ExrPicture& film, const Worlds& worlds, Picture& picture);

  template <class Film>
  void make_file(Film&& film, const std::string& recipe, Picture& picture) const;
  void tell_reached(Picture& picture) const;
  void tell_errors(Picture& picture) const;
  template <class Film>
  void show(const Glimpse& glimpse, Film& film);

  const Plan& plan_;
  const RenderContext& context_;
  const std::stop_token& stop_;
  const Onlooker* const onlooker_;
  Flow own_{};
  Flow& flow_;
  const Workers workers_;
  Stopwatch watch_{};
  int seen_ = 0;  // how many glimpses
};

}  // namespace tia::server
