// How the frames of a film become a file.
#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "server/requests/film_plan.h"
#include "server/stores/picture.h"

namespace tia::server {

/// FilmTools: what encoders need of their host, and until when.
struct FilmTools {
  const OutsideEncoder& ffmpeg;
  std::stop_token stop;
};

/// FilmEncoder: makes one film's file piece by piece; a piece may be empty.
class FilmEncoder {
 public:
  FilmEncoder() = default;
  FilmEncoder(const FilmEncoder&) = delete;
  FilmEncoder& operator=(const FilmEncoder&) = delete;
  virtual ~FilmEncoder() = default;

  /// The piece before all pictures.
  virtual std::string begin() { return {}; }
  /// The piece that shows this picture, in the order of the plan's shots.
  virtual std::string add(const Picture& picture, const Shot& shot) = 0;
  /// The last piece.
  virtual std::string end() = 0;
  /// Whether it waits for another process, and keeps no thread at work meanwhile.
  virtual bool waits() const { return false; }
};

/// The encoder of that format. The plan outlives it. Errors: std::system_error where ffmpeg cannot
/// be started.
std::unique_ptr<FilmEncoder> encoder_of(FilmFormat format, const FilmPlan& film,
                                        const FilmTools& tools);

}  // namespace tia::server
