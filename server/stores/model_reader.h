// ModelReader: reads models in a process of their own.
#pragma once

#include <stdexcept>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "core/models/formats.h"
#include "core/models/kept_model.h"
#include "core/models/zip.h"
#include "server/operation/byte_buffer.h"
#include "server/operation/confined.h"

namespace tia::server {

/// ReaderDied: the process was killed, or answered what nobody can read. The file is at fault, or
/// the reader; not who asks.
struct ReaderDied : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// ModelReader. Constant; threads may share it.
class ModelReader {
 public:
  /// The program is this one, which knows `read-model`, unless tests say another.
  explicit ModelReader(const Confinement& confinement, std::string program = "/proc/self/exe")
      : confinement_(confinement), program_(std::move(program)) {}

  /// The model with what its pictures hold, whose files it is without.
  /// Cost: a process, some 2 ms; its memory is its own. Here that of what is made of the answer as
  /// it comes. Errors: InputError as read_model's and decode_images', and of a `limit` where the
  /// file takes more time or memory than the process may; ReaderDied; std::system_error where no
  /// process can be had; Stopped.
  KeptModel read(const ModelFiles& files, const ModelLimits& limits,
                 const std::stop_token& stop = {}) const;

  /// Unpacked: the files of an archive, as views into the bytes beside them.
  struct Unpacked {
    ByteBuffer bytes;
    std::vector<ModelFile> files;
  };
  /// Unpacks an archive. Cost, Errors: as read()'s, with unpack_zip's faults.
  Unpacked unpack(ModelBytes archive, const ZipLimits& limits,
                  const std::stop_token& stop = {}) const;

 private:
  ByteBuffer answer_to(const std::string& head, std::vector<ModelBytes> pieces, std::size_t longest,
                       const std::stop_token& stop) const;

  Confinement confinement_;
  std::string program_;
};

/// What such a process does: `tia read-model MEMORY_BYTES CPU_S`. Does not return.
[[noreturn]] void answer_as_reader(const Confinement& confinement);

}  // namespace tia::server
