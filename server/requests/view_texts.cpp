#include "server/requests/view_texts.h"

#include "core/film/png_text.h"

namespace tia::server {
namespace {

bool is_panorama(const Plan& plan) {
  if (plan.scene->sheet || has_display(plan.scene->camera)) return false;
  return plan.scene->camera.projection == Projection::equirectangular;
}

std::string gpano(const Plan& plan) {
  const auto tag = [](const char* name, const std::string& value) {
    return std::string(" GPano:").append(name).append("=\"").append(value).append("\"");
  };
  const Window &whole = plan.whole, &part = plan.window;
  return "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\">"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
         "<rdf:Description rdf:about=\"\" "
         "xmlns:GPano=\"http://ns.google.com/photos/1.0/panorama/\"" +
         tag("ProjectionType", "equirectangular") + tag("UsePanoramaViewer", "True") +
         tag("FullPanoWidthPixels", std::to_string(whole.width())) +
         tag("FullPanoHeightPixels", std::to_string(whole.height())) +
         tag("CroppedAreaImageWidthPixels", std::to_string(part.width())) +
         tag("CroppedAreaImageHeightPixels", std::to_string(part.height())) +
         tag("CroppedAreaLeftPixels", std::to_string(part.x0)) +
         tag("CroppedAreaTopPixels", std::to_string(part.y0)) + "/></rdf:RDF></x:xmpmeta>";
}

// The scene's own name, where it has one of plain letters, as of the gallery.
std::string base_name(const Plan& plan) {
  const auto* name = std::get_if<std::string>(&plan.asked->scene);
  const bool is_plain =
      name != nullptr && name->size() <= 40 && !name->empty() &&
      name->find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
  return is_plain ? *name : "tia";
}

}  // namespace

std::string with_view_texts(std::string png, const Plan& plan) {
  if (!plan.views.suffix.empty() && plan.window == plan.whole)
    png = with_plain_text(std::move(png), "Tia quilt", plan.views.suffix);
  if (is_panorama(plan)) png = with_plain_text(std::move(png), "XML:com.adobe.xmp", gpano(plan));
  return png;
}

std::string disposition_of(const Plan& plan) {
  const bool is_archive = plan.format == Format::zip;
  const bool is_quilt = !plan.views.suffix.empty() && plan.window == plan.whole;
  if (!is_archive && !is_quilt) return "";
  std::string name = base_name(plan);
  if (is_quilt) name += '_' + plan.views.suffix;
  return std::string(is_archive ? "attachment" : "inline") + "; filename=\"" + name + '.' +
         std::string(name_of(plan.format)) + '"';
}

}  // namespace tia::server
