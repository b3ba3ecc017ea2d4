// Films, drawn frame by frame while they are encoded.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "server/requests/film_frames.h"
#include "server/requests/film_plan.h"
#include "server/stores/picture.h"

namespace tia::server {

/// Crew: who draws a film's pictures and takes its file.
struct Crew {
  /// The picture of that plan, one of the frames', whose tag is the shot's.
  using Draw = std::shared_ptr<const Picture>(FilmFrames& frames, Plan& plan, const Shot& shot);
  std::function<Draw> draw;
  /// Does what takes one thread's time when it is its turn.
  std::function<void(const std::function<void()>& work)> alone;
  /// Takes the file's next piece, which is not empty; may wait.
  std::function<void(std::string_view piece)> take;
};

/// Draws the shots in their order, each once, and hands on what the file is by then: nothing is
/// drawn ahead of what has been taken. Errors: what the crew throws, and as plan_of; then the file
/// is not whole.
void shoot(FilmRequest& asked, const FilmPlan& film, const RenderContext& context,
           const Requester& requester, const Crew& crew);

}  // namespace tia::server
