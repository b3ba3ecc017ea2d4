#include "server/stores/model_reader.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <new>

#include "server/operation/child_talk.h"
#include "server/stores/exchange_parts.h"
#include "server/stores/model_exchange.h"
#include "server/stores/streamed_answer.h"
#include "server/stores/unpack_exchange.h"

namespace tia::server {
namespace {

// What the process ends with.
constexpr int answered = 0, no_memory = 3, not_confined = 4, no_request = 5;

InputError beyond(std::string got, std::string allowed) {
  return InputError({FaultKind::limit, "", Value(std::move(got)), std::move(allowed)});
}

void judge(int status, const Confinement& confinement) {
  if (WIFSIGNALED(status)) {
    if (WTERMSIG(status) == SIGXCPU)
      throw beyond("a model that takes longer to read",
                   std::to_string(confinement.cpu_s) + " s of a processor");
    throw ReaderDied("the reader was killed by signal " + std::to_string(WTERMSIG(status)));
  }
  const int code = WEXITSTATUS(status);
  if (code == no_memory)
    throw beyond("a model that takes more memory to read",
                 std::to_string(confinement.memory_bytes) +
                     " bytes (TIA_MODEL_MEMORY_BYTES, --model-memory-bytes)");
  if (code == not_confined)
    throw ReaderDied("this machine does not confine processes: seccomp(2) is missing");
  if (code != answered) throw ReaderDied("the reader ended with " + std::to_string(code));
}

// What read() makes of an answer, where it is one.
template <class Read>
auto believed(const Read& read) {
  try {
    return read();
  } catch (const NoAnswer& error) {
    throw ReaderDied(std::string("the reader answered ") + error.what());
  }
}

std::vector<std::string> arguments_of(const Confinement& confinement) {
  return {"read-model", std::to_string(confinement.memory_bytes),
          std::to_string(confinement.cpu_s)};
}

ModelBytes bytes_of(const std::string& head) {
  return {reinterpret_cast<const std::uint8_t*>(head.data()), head.size()};
}

/// ChildAnswer: what the process writes; what is short, from a piece that is read at once.
class ChildAnswer : public ByteSource {
 public:
  explicit ChildAnswer(ChildTalk& talk) : talk_(talk), piece_(std::size_t{1} << 16U) {}
  std::size_t read(std::span<std::uint8_t> room) override {
    if (at_ == size_ && room.size() >= piece_.size()) return talk_.read(room);
    if (at_ == size_) {
      at_ = 0;
      size_ = talk_.read(piece_);
    }
    const std::size_t got = std::min(room.size(), size_ - at_);
    std::copy_n(piece_.data() + at_, got, room.data());
    at_ += got;
    return got;
  }
  std::uint64_t most() const override { return size_ - at_ + talk_.left(); }

 private:
  ChildTalk& talk_;
  std::vector<std::uint8_t> piece_;
  std::size_t at_ = 0, size_ = 0;
};

// ---- the process itself -------------------------------------------------------------------------

// All of standard input. There is room for all of it once its head is there, and for its end.
ByteBuffer read_input() {
  constexpr std::size_t piece = std::size_t{1} << 20U;
  ByteBuffer all;
  for (;;) {
    if (all.is_full()) all.reserve(std::max(all.size() + piece, request_length(all) + 1));
    const auto room = all.room(1);
    const ssize_t got = read(STDIN_FILENO, room.data(), room.size());
    if (got == 0) return all;
    if (got < 0 && errno != EINTR) throw std::runtime_error("no request: it cannot be read");
    if (got > 0) all.add(static_cast<std::size_t>(got));
  }
}

void write_output(std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t put = write(STDOUT_FILENO, bytes.data(), bytes.size());
    if (put < 0 && errno != EINTR) return;  // nobody listens any more
    if (put > 0) bytes = bytes.subspan(static_cast<std::size_t>(put));
  }
}

int answer() {
  try {
    server::answer_to(read_input()).each_part(write_output);
    return answered;
  } catch (const std::bad_alloc&) {
    return no_memory;
  } catch (const std::exception&) {
    return no_request;
  }
}

// Whether the process is confined.
bool confined(const Confinement& confinement) {
  try {
    confine(confinement);
    return true;
  } catch (const std::exception& error) {
    std::cerr << "tia: " << error.what() << '\n';
    return false;
  }
}

}  // namespace

ByteBuffer ModelReader::answer_to(const std::string& head, std::vector<ModelBytes> pieces,
                                  std::size_t longest, const std::stop_token& stop) const {
  pieces.insert(pieces.begin(), bytes_of(head));
  ChildEnd end = run_child(program_, arguments_of(confinement_), pieces, longest, stop);
  judge(end.status, confinement_);
  return std::move(end.output);
}

// How the process has ended counts before what it has written; unless that is still going on, which
// is no answer.
KeptModel ModelReader::read(const ModelFiles& files, const ModelLimits& limits,
                            const std::stop_token& stop) const {
  const std::string head = request_head(files, limits);
  std::vector<ModelBytes> pieces{bytes_of(head)};
  for (const ModelFile& each : files.all) pieces.push_back(each.bytes);
  ChildTalk talk(program_, arguments_of(confinement_), std::move(pieces), confinement_.memory_bytes,
                 stop);
  ChildAnswer answer(talk);
  KeptModel model = believed([&] {
    try {
      return model_of(answer, limits);
    } catch (...) {
      if (talk.ended()) judge(talk.end(), confinement_);
      throw;
    }
  });
  judge(talk.end(), confinement_);
  return model;
}

ModelReader::Unpacked ModelReader::unpack(ModelBytes archive, const ZipLimits& limits,
                                          const std::stop_token& stop) const {
  Unpacked unpacked;
  unpacked.bytes = answer_to(unpack_head(limits), {archive}, longest_unpacked(limits), stop);
  unpacked.files = believed([&] { return unpacked_files(unpacked.bytes, limits); });
  return unpacked;
}

void answer_as_reader(const Confinement& confinement) {
  const int status = confined(confinement) ? answer() : not_confined;
  _exit(status);  // of all ways to end only exit_group is allowed
}

}  // namespace tia::server
