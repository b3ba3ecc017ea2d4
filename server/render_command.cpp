#include "server/render_command.h"

#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "server/picture.h"
#include "server/text_form.h"

namespace tia::server {
namespace {

std::string read_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_file(const std::string& name, const std::string& bytes) {
  if (name == "-") {
    std::cout << bytes << std::flush;
    if (!std::cout) throw std::runtime_error("cannot write to standard output");
    return;
  }
  std::ofstream file(name, std::ios::binary | std::ios::trunc);
  file << bytes << std::flush;
  if (!file) throw std::runtime_error("cannot write " + name);
}

}  // namespace

void render_to_file(const std::string& scene, const std::string& file,
                    const std::vector<Setting>& parameters, const Config& config) {
  Value::Object asked;
  const bool is_file = scene.ends_with(".json");
  asked.emplace_back("scene", is_file ? parse_json(read_file(scene)) : Value(scene));
  if (file.ends_with(".pfm")) asked.emplace_back("format", "pfm");
  for (const Setting& each : parameters) {
    std::erase_if(asked, [&](const auto& member) { return member.first == each.name; });
    asked.emplace_back(each.name, field_from_text<PictureRequest>(each.name, each.text));
  }
  const Gallery gallery;
  Pool pool(config.threads);
  const Studio studio{gallery, pool, Limits{.max_pixels = config.max_pixels}};
  write_file(file, draw(read_described<PictureRequest>(asked), studio, {}).bytes);
}

}  // namespace tia::server
