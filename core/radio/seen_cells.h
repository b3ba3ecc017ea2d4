// Paths to many receivers that stand side by side: what sequences of faces there are is found once
// for all of them, and each is tried where its image can be seen.
#pragma once

#include <atomic>
#include <span>

#include "core/radio/images.h"
#include "core/radio/radio_beam.h"
#include "core/radio/radio_question.h"

namespace tia {

/// MirrorSequences: which sequences of flat faces may lead from one transmitter to receivers.
class MirrorSequences {
 public:
  /// Domain: a world without curved bodies, a method other than sbr. `search.to` is not looked at.
  /// Errors: InputError (limit) of more images than search.most_images; Stopped.
  MirrorSequences(const RadioWorld& world, const PathSearch& search, const RadioQuestion& question,
                  const Workers& workers);

  const PathCounts& counts() const { return counts_; }
  /// The paths to receivers, as paths_from (radio_search.h) finds them for each alone, to the bit.
  /// `images`: counts those that are tried. Errors: InputError (limit) of more than `most_images`.
  std::vector<std::vector<RadioPath>> paths_to(std::span<const Vec3d> receivers,
                                               std::atomic<std::int64_t>& images,
                                               std::int64_t most_images) const;

 private:
  void add_edges(const Vec3d& receiver, std::vector<RadioPath>& paths) const;

  const RadioWorld& world_;
  PathSearch search_;
  std::vector<ImageNode> nodes_;
  PathCounts counts_;
  double margin_;  // what beams are wider by
};

}  // namespace tia
