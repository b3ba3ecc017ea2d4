// The program: reads its command line and does what that says. Bad use exits with 2.
#include <csignal>
#include <iostream>

#include "server/commands/commands.h"

int main(int argc, char** argv) {
  using tia::server::CommandLine;
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow: the write's error is enough
  try {
    CommandLine line;
    for (const auto add : tia::server::commands) add(line);
    return line.run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "tia: " << error.what() << '\n';
    return CommandLine::bad_use;
  }
}
