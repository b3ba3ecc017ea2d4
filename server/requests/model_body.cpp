#include "server/requests/model_body.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/models/bundle.h"
#include "core/models/formats.h"
#include "core/models/multipart.h"
#include "core/models/zip.h"
#include "server/http/error.h"
#include "server/stores/model_folder.h"

namespace tia::server {
namespace {

/// ForeignFormat: one that is not read, but may come often, by its first bytes or a path's end.
struct ForeignFormat {
  std::string_view words, start, ending;
};
constexpr std::array foreign_formats{
    ForeignFormat{"FBX", "Kaydara FBX Binary", ".fbx"}, ForeignFormat{"FBX", "; FBX ", ".fbx"},
    ForeignFormat{"USD", "PXR-USDC", ".usdc"}, ForeignFormat{"USD", "#usda ", ".usda"},
    ForeignFormat{"3MF", "", ".model"}};

const ForeignFormat* foreign_format_of(const ModelFile& file) {
  const std::string_view text(reinterpret_cast<const char*>(file.bytes.data()), file.bytes.size());
  const auto* const row = std::ranges::find_if(foreign_formats, [&](const ForeignFormat& each) {
    return file.path.ends_with(each.ending) ||
           (!each.start.empty() && text.starts_with(each.start));
  });
  return row == foreign_formats.end() ? nullptr : row;
}

[[noreturn]] void refuse_format(const std::vector<ModelFile>& files) {
  const std::string taken = "a file of " + model_formats() +
                            ", or a ZIP archive or multipart/form-data of one and what it names";
  for (const ModelFile& file : files)
    if (const ForeignFormat* const row = foreign_format_of(file))
      throw HttpError("media-type", std::string(row->words) +
                                        " is not read here: export it as GLB; what is taken is " +
                                        taken);
  throw HttpError("media-type", "this is no model that is read here; send " + taken);
}

ModelBytes body_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

// The files of a form.
std::vector<ModelFile> files_in(ModelBytes body, std::string_view type, Faults& faults) {
  std::vector<ModelFile> files{{"model", body}};
  if (const auto boundary = boundary_of(type))
    files = files_of(parse_multipart(body, *boundary, faults), faults);
  return files;
}

}  // namespace

SentModel model_in(const Request& request, const std::string& main, std::int64_t most_unpacked,
                   ModelStore& models) {
  Faults faults(request.stop);
  SentModel sent;
  auto* const sent_file = dynamic_cast<SentFile*>(request.long_body.get());
  if (sent_file != nullptr) sent.body = std::make_unique<const std::string>(sent_file->contents());
  const ModelBytes body = body_of(sent.body ? *sent.body : request.body);
  ModelFiles files;
  const ZipLimits limits{.bytes = static_cast<std::uint64_t>(most_unpacked)};
  files.all = files_in(body, request.header("Content-Type"), faults);
  faults.raise();
  if (files.all.size() == 1 && is_zip(files.all.front().bytes)) {
    auto unpacked = models.unpack(files.all.front().bytes, limits, request.stop);
    files.all = std::move(unpacked.files);
    sent.unpacked = std::move(unpacked.bytes);
  }
  const bool is_foreign =
      std::ranges::any_of(files.all, [](const ModelFile& file) { return foreign_format_of(file); });
  files.main = main_of(files.all, main, faults);
  if (!faults.empty() && is_foreign) refuse_format(files.all);
  faults.raise();
  if (format_of(files.main_file().bytes) == nullptr) refuse_format(files.all);
  strip_lone_folder(files.all);
  const bool in_file = sent_file != nullptr && files.main_file().bytes.data() == body.data();
  sent.upload = upload_of(std::move(files), in_file ? sent_file->sha256() : "");
  if (in_file) sent.upload.in_file = &sent_file->file();
  return sent;
}

}  // namespace tia::server
