// The body of a request as the files of a model: one file, a ZIP archive or a form of several.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/input/fields.h"
#include "core/models/paths.h"
#include "server/http/message.h"
#include "server/operation/byte_buffer.h"
#include "server/stores/model_store.h"
#include "server/stores/model_upload.h"

namespace tia::server {

/// ModelQuery: the parameters of a request that sends a model.
struct ModelQuery {
  static constexpr std::string_view schema_name = "model_query";
  std::string main;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("main", &ModelQuery::main,
          Spec{.about = "the path of the file that is the model, where several could be meant",
               .max_bytes = longest_path});
  }
};

/// SentModel: the files that a body holds, what was unpacked for them, and the body itself where it
/// has gone to the disk. The request outlives it.
struct SentModel {
  std::unique_ptr<const std::string> body;
  ByteBuffer unpacked;
  ModelUpload upload;
};

/// What is sent, of at most so many bytes unpacked, which `models` unpacks; bytes decide what it
/// is, and no type that is declared but multipart/form-data's. Errors: HttpError (media-type) where
/// the main file is of no format; InputError as parse_multipart(), files_of() and main_of(); as
/// ModelStore::unpack; StorageError. Cost: reads all bytes.
SentModel model_in(const Request& request, const std::string& main, std::int64_t most_unpacked,
                   ModelStore& models);

}  // namespace tia::server
