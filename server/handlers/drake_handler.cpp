// POST /render of a form: pictures for Drake's RenderEngineGltfClient.
#include "core/models/formats.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/rendered.h"
#include "server/handlers/sent_model.h"
#include "server/http/error.h"
#include "server/requests/accept.h"
#include "server/requests/drake_form.h"

namespace tia::server {
namespace {

// What is no hash is of no interest: older clients send other text.
void check_hash(const DrakeForm& form, const std::string& id) {
  if (!form.scene_sha256 || form.scene_sha256->size() != id.size()) return;
  std::string hash = *form.scene_sha256;
  for (char& c : hash)
    if (c >= 'A' && c <= 'F') c = static_cast<char>(c - 'A' + 'a');
  if (is_model_id(hash) && hash != id)
    throw InputError({FaultKind::conflict, "/scene_sha256", Value(*form.scene_sha256),
                      id + ", the SHA-256 of the scene that has come"});
}

// Faults of the file are the scene's.
KnownModel read_scene_of(const ModelUpload& upload, const Requester& requester, Service& service) {
  if (format_of(upload.files.main_file().bytes) == nullptr)
    throw HttpError("media-type", "the field scene is no model that is read here; send a file of " +
                                      model_formats() + ", for its camera one of glTF");
  try {
    return service.models.look_into(upload, requester);
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer.insert(0, "/scene");
    throw InputError(std::move(faults));
  }
}

}  // namespace

Response rendered_form(const Request& request, std::string_view boundary, Stopwatch watch,
                       Service& service) {
  const std::size_t bytes = request.body.size();
  check_length(bytes, model_limit(service.config));
  const auto query =
      read_described<DrakeQuery>(query_object<DrakeQuery>(request.query()), {}, request.stop);
  const Requester requester = requester_of(request);
  ModelUpload upload;
  const DrakeForm form = service.rendering.long_work(
      {bytes, memory_for(memory_cost::model, bytes), "the form"}, requester, [&] {
        SentForm sent = read_drake_form(request.body, boundary, request.stop);
        upload = upload_of({.all = {{"scene.gltf", sent.scene}}, .main = 0});
        return std::move(sent.form);
      });
  static_cast<void>(preferred_type(request, {media_type_of(form.image_type)}));
  check_hash(form, upload.id);
  const KnownModel known = read_scene_of(upload, requester, service);
  AskedPicture asked;
  asked.picture = service.rendering.go_through(bytes_of(*known.model), requester, [&] {
    return drake_picture(form, query, upload.id, known.model);
  });
  return rendered(asked, watch, request, service);
}

}  // namespace tia::server
