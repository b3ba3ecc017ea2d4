#include "server/operation/child_talk.h"
#include "server/operation/confined.h"

namespace tia::server {

ChildEnd run_child(const std::string& program, const std::vector<std::string>& arguments,
                   const std::vector<std::span<const std::uint8_t>>& input, std::size_t most_output,
                   const std::stop_token& stop) {
  constexpr std::size_t piece = 1 << 16;
  ChildTalk talk(program, arguments, input, most_output, stop);
  ChildEnd end;
  while (const std::size_t got = talk.read(end.output.room(piece))) end.output.add(got);
  end.status = talk.end();
  return end;
}

}  // namespace tia::server
