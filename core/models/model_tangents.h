// The tangents of a model's parts that its file does not have: made when they are first asked for,
// and kept.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/input/shared_list.h"
#include "core/models/model.h"

namespace tia {

/// TangentLists: as TangentVertices, but its longest lists are shared by all that show them.
struct TangentLists {
  std::vector<std::uint32_t> from;
  SharedList<std::uint32_t> indices;
  SharedList<double> tangents;
};

/// ModelTangents: of one kept model. Any thread may ask; while some are made the others wait.
class ModelTangents {
 public:
  using Tangents = std::shared_ptr<const TangentLists>;

  /// Those of a part along a texture's rows, as make() gives them. Of the same part the last rows
  /// that were asked for are known. Domain: one of the model's parts, as it is without a pose.
  Tangents of(const ModelPart& part, const TextureUse& along,
              const std::function<TangentLists()>& make);

 private:
  struct Known {
    TextureUse along;
    Tangents tangents;
  };
  std::mutex mutex_;
  std::map<const ModelPart*, Known> known_;
};

}  // namespace tia
