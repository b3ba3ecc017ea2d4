#include "server/requests/shooting.h"

#include "server/requests/film_encoders.h"

namespace tia::server {

void shoot(FilmRequest& asked, const FilmPlan& film, const RenderContext& context,
           const Requester& requester, const Crew& crew) {
  std::unique_ptr<FilmEncoder> encoder;
  crew.alone([&] {
    encoder = encoder_of(asked.film_format, film, {context.ffmpeg, requester.stop});
  });
  const auto hand_on = [&](const auto& encode) {
    std::string piece;
    const auto work = [&] { piece = encode(); };
    if (encoder->waits()) work();
    else crew.alone(work);
    if (!piece.empty()) crew.take(piece);
  };
  hand_on([&] { return encoder->begin(); });
  FilmFrames frames(asked, film.scene);
  for (const Shot& shot : film.shots) {
    end_if_asked(requester.stop);
    Plan plan = frames.plan_at(film.seconds_of(shot.first), context, requester);
    const auto picture = crew.draw(frames, plan, shot);
    hand_on([&] { return encoder->add(*picture, shot); });
  }
  hand_on([&] { return encoder->end(); });
}

}  // namespace tia::server
