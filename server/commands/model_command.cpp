// `tia model FILE`: what is told of a model's file, without a server; and who reads it.
#include <iostream>

#include "core/input/json.h"
#include "core/models/describe.h"
#include "server/commands/commands.h"
#include "server/commands/flags.h"
#include "server/commands/model_sources.h"
#include "server/stores/model_reader.h"

namespace tia::server {
namespace {

struct ModelAsked {
  std::vector<std::string> files;
};

// To standard output, as GET /models/{id} tells it.
void describe_model(const ModelAsked& asked) {
  const ModelReader reader(Confinement{});
  read_model_files(asked.files, [&](const ModelFiles& files) {
    std::cout << to_json(description_of(*reader.read(files, {}).model)) << std::endl;
  });
}

}  // namespace

void add_model(CommandLine& line) {
  auto& asked = line.keep<ModelAsked>();
  Command model =
      line.add("model", "tell what is in a model's file, as JSON", [&] { describe_model(asked); });
  add_model_files(model, asked.files);
}

// What the server starts: nobody else should.
void add_read_model(CommandLine& line) {
  auto& asked = line.keep<Confinement>();
  Command reader = line.add("read-model", "", [&] { answer_as_reader(asked); });
  reader.hide();
  reader.number("memory_bytes", asked.memory_bytes);
  reader.number("cpu_s", asked.cpu_s);
}

}  // namespace tia::server
