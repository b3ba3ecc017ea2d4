// `tia serve`, which the program does where nothing else is asked, and `tia worker`.
#include <iostream>

#include "server/commands/commands.h"
#include "server/commands/flags.h"
#include "server/commands/serving.h"
#include "server/jobs/farm.h"

namespace tia::server {
namespace {

struct ServeAsked {
  bool healthcheck = false, print_config = false;
};

void serve_or_tell(const ServeAsked& asked, CommandLine& line) {
  const Config config = line.config();
  if (asked.healthcheck) line.status = is_healthy(config) ? 0 : 1;
  else if (asked.print_config) std::cout << env_file(config) << std::flush;
  else serve(config);
}

}  // namespace

// Its flags are the program's own, too.
void add_serve(CommandLine& line) {
  auto& asked = line.keep<ServeAsked>();
  const auto action = [&] { serve_or_tell(asked, line); };
  line.otherwise(action);
  line.program().flag("--healthcheck", asked.healthcheck,
                      "ask the server on this machine whether it lives");
  for (Command each : {line.program(), line.add("serve", "serve over HTTP (default)", action)}) {
    each.flag("--print-config", asked.print_config,
              "print every option's value as a file of variables (docker's --env-file), and exit");
    line.take_options(each);
  }
}

void add_worker(CommandLine& line) {
  auto& name = line.keep<std::string>();
  name = own_worker_name();
  Command worker = line.add("worker", "draw parts of the jobs of a farm (TIA_FARM)",
                            [&] { work(line.config(), name); });
  worker.option("--name", name, "what the others are told it is called [machine and process]");
  line.take_options(worker);
}

}  // namespace tia::server
