// How the frames of a film become a file.
#pragma once

#include <memory>
#include <string>

#include "server/requests/film_plan.h"
#include "server/stores/picture.h"

namespace tia::server {

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
};

/// The encoder of that format. The plan outlives it.
std::unique_ptr<FilmEncoder> encoder_of(FilmFormat format, const FilmPlan& film);

}  // namespace tia::server
