#include "server/handlers/live_film.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "server/requests/film_frames.h"

namespace tia::server {
namespace {

/// Playing: where a film is.
class Playing {
 public:
  explicit Playing(const FilmPlan& film) : film_(film) {}

  const Shot& shot() const { return film_.shots[at_]; }
  bool is_last() const { return at_ + 1 == film_.shots.size(); }
  void begin() { start_ = Clock::now(); }
  Clock::time_point time_of(int frame) const {
    const std::chrono::duration<double> since{frame / film_.fps};
    return start_ + std::chrono::duration_cast<Clock::duration>(since);
  }
  /// On to the next shot that is still on at that time, or the last one.
  void go_on(Clock::time_point to) {
    while (!is_last()) {
      ++at_;
      if (time_of(shot().first + shot().frames) > to) return;
    }
  }

 private:
  const FilmPlan& film_;
  std::size_t at_ = 0;
  Clock::time_point start_{};
};

}  // namespace

void play(FilmRequest& asked, const FilmPlan& film, const RenderContext& context,
          const Requester& requester, LivePictures& pictures) {
  Playing playing(film);
  FilmFrames frames(asked, film.scene);
  for (bool has_begun = false;;) {
    const auto begun = Clock::now();
    const Shot& shot = playing.shot();
    Plan plan = frames.plan_at(film.seconds_of(shot.first), context, requester);
    const auto jpeg = pictures.draw(plan);
    const auto took = Clock::now() - begun;
    if (!std::exchange(has_begun, true)) playing.begin();
    if (jpeg) {
      pictures.wait_until(playing.time_of(shot.first));
      const int frame = film.first + shot.first;
      pictures.show(*jpeg, {{"Tia-Frame", std::to_string(frame)}}, playing.is_last());
      if (playing.is_last()) return;
    }
    playing.go_on(Clock::now() + took);
  }
}

}  // namespace tia::server
