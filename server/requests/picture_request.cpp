#include "server/requests/picture_request.h"

#include <algorithm>

#include "core/version.h"

namespace tia::server {
namespace {

// Where a query's + has become a space, too.
bool is_this_version(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '+');
  return text == version() || text == full_version();
}

}  // namespace

void PictureRequest::check(const Place& at, Faults& faults) const {
  ViewRequest::check(at, faults);
  if (const Window w = window(); w.x0 >= w.x1 || w.y0 >= w.y1)
    faults.add({FaultKind::out_of_range, at.at("crop").pointer(), write_value(crop),
                "x0 < x1 and y0 < y1, within the picture"});
  if (depth_range && (*depth_range)[0] > (*depth_range)[1])
    faults.add({FaultKind::out_of_range, at.at("depth_range").pointer(), write_value(*depth_range),
                "near,far, of which far is not less than near"});
  if (v && !is_this_version(*v))
    faults.add({FaultKind::out_of_range, at.at("v").pointer(), Value(*v),
                full_version() + ", which this server draws; or none, for whatever it draws"});
  check_exr(at, faults);
}

void PictureRequest::check_exr(const Place& at, Faults& faults) const {
  const auto check_format = [&](const char* name, const auto& given) {
    if (given && format != Format::exr)
      faults.add({FaultKind::conflict, at.at(name).pointer(), write_value(*given),
                  std::string(name) + " with format exr; this picture's is " +
                      std::string(name_of(format))});
  };
  check_format("aov", aov);
  check_format("depth", depth);
  if (depth && *depth != 16 && *depth != 32)
    faults.add({FaultKind::out_of_range, at.at("depth").pointer(), Value(*depth), "16 or 32"});
  LayerSet seen;
  for (std::size_t i = 0; aov && i < aov->size(); ++i) {
    if (seen.has((*aov)[i]))
      faults.add({FaultKind::conflict, at.at("aov").at(i).pointer(), write_value((*aov)[i]),
                  "each layer once"});
    seen.add((*aov)[i]);
  }
}

Window PictureRequest::window() const {
  if (!crop) return {0, 0, width, height};
  return {(*crop)[0], (*crop)[1], (*crop)[2], (*crop)[3]};
}

LayerSet PictureRequest::layers_in_effect() const {
  if (!aov) return {Layer::rgba};
  LayerSet asked;
  for (const Layer each : *aov) asked.add(each);
  return asked;
}

std::string alpha_formats() {
  std::vector<std::string_view> names;
  for (const FormatRow& row : formats)
    if (row.has_alpha) names.push_back(row.name);
  return listed(names);
}

}  // namespace tia::server
