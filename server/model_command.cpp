#include "server/model_command.h"

#include <iostream>

#include "core/input/json.h"
#include "core/models/describe.h"
#include "server/model_sources.h"
#include "server/stores/model_reader.h"

namespace tia::server {

void describe_model(const std::vector<std::string>& names) {
  const ModelReader reader(Confinement{});
  read_model_files(names, [&](const ModelFiles& files) {
    std::cout << to_json(description_of(*reader.read(files, {}).model)) << std::endl;
  });
}

}  // namespace tia::server
