#include "server/stores/model_store.h"

#include <algorithm>
#include <utility>

#include "core/input/json.h"
#include "core/models/describe.h"
#include "server/contract/problem.h"
#include "server/operation/memory_costs.h"
#include "server/stores/gallery_models.h"

namespace tia::server {
namespace {

// A file that came alone has no path.
Value files_value(const ModelFiles& files) {
  Value::Array list;
  for (const ModelFile& file : files.all) {
    Value::Object each{{"bytes", static_cast<double>(file.bytes.size())}};
    if (files.all.size() > 1) each.emplace_back("path", file.path);
    list.push_back(std::move(each));
  }
  return list;
}

std::string text_of_model(const ModelUpload& upload, const Model& model) {
  Value::Object told{{"id", upload.id},
                     {"bytes", static_cast<double>(upload.bytes())},
                     {"files", files_value(upload.files)}};
  Value description = description_of(model);
  for (auto& member : *description.as<Value::Object>()) told.push_back(std::move(member));
  return to_json(told);
}

double seconds_since(ModelStore::Time start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

ModelStore::ModelStore(ModelReader reader, const Bounds& bounds, const Surroundings& surroundings,
                       std::unique_ptr<ModelFolder> folder, Now now)
    : reader_(std::move(reader)),
      limits_(bounds.limits),
      long_work_(surroundings.long_work),
      metrics_(surroundings.metrics),
      now_(std::move(now)),
      uploads_(bounds.max_bytes, surroundings.memory, std::move(folder)),
      read_(bounds.max_bytes, surroundings.memory) {}

ModelStore::Kept ModelStore::keep(const ModelUpload& upload, const Requester& requester) {
  const bool is_new = !contains(upload.id);
  KnownModel known = look_into(upload, requester);
  if (gallery_model(upload.id) == nullptr) uploads_.keep(upload);
  read_.add(upload.id, known);
  return {std::move(known), is_new};
}

KnownModel ModelStore::look_into(const ModelUpload& upload, const Requester& requester) {
  if (KnownModel known = read_.find(upload.id)) return known;
  return read(upload, requester);
}

ModelReader::Unpacked ModelStore::unpack(ModelBytes archive, const ZipLimits& limits,
                                         const std::stop_token& stop) {
  const std::string id =
      sha256_hex({reinterpret_cast<const char*>(archive.data()), archive.size()});
  check_rest(id);
  const Time start = std::chrono::steady_clock::now();
  try {
    return reader_.unpack(archive, limits, stop);
  } catch (const ReaderDied&) {
    metrics_.count("zip", ModelReading::died, seconds_since(start));
    remember_death(id);
    throw;
  }
}

bool ModelStore::contains(const std::string& name) {
  return gallery_model(name) != nullptr || (is_model_id(name) && uploads_.contains(name));
}

bool ModelStore::remove(const std::string& id) {
  if (!uploads_.remove(id)) return false;
  read_.remove(id);
  return true;
}

KnownModel ModelStore::find(const std::string& name, const Requester& requester) {
  if (const GalleryModel* model = gallery_model(name))
    return find_packed(model->id, model->bytes, requester);
  if (!contains(name)) return {};
  if (KnownModel known = read_.find(name)) return known;
  const auto packed = uploads_.find(name);
  return packed ? find_packed(name, *packed, requester) : KnownModel{};
}

KnownModel ModelStore::find_packed(const std::string& id, std::string_view packed,
                                   const Requester& requester) {
  if (KnownModel known = read_.find(id)) return known;
  const auto upload = unpacked_upload(id, packed);
  if (!upload) throw StorageError("the model " + id + " is damaged");
  KnownModel known = read(*upload, requester);
  read_.add(id, known);
  return known;
}

// In the places of long texts, however short it is: each has a process. The turn that it takes
// among the threads is its process's.
KnownModel ModelStore::read(const ModelUpload& upload, const Requester& requester) {
  check_rest(upload.id);
  const std::size_t bytes = std::max(upload.bytes(), Admission::longest_short_text + 1);
  return long_work_({bytes, memory_for(memory_cost::model, bytes), "the model"}, requester,
                    [&] { return read_now(upload, requester.stop); });
}

KnownModel ModelStore::read_now(const ModelUpload& upload, const std::stop_token& stop) {
  const Time start = std::chrono::steady_clock::now();
  const ModelFormat* const format = format_of(upload.files.main_file().bytes);
  const std::string_view name = format == nullptr ? "unknown" : format->name;
  const auto count = [&](ModelReading result) {
    metrics_.count(name, result, seconds_since(start));
  };
  try {
    SharedModel model = model_of(upload, stop);
    auto text = std::make_shared<const std::string>(text_of_model(upload, *model->model));
    count(ModelReading::read);
    return {std::move(model), std::move(text)};
  } catch (const InputError&) {
    count(ModelReading::refused);
    throw;
  } catch (const ReaderDied&) {
    count(ModelReading::died);
    remember_death(upload.id);
    throw;
  }
}

SharedModel ModelStore::model_of(const ModelUpload& upload, const std::stop_token& stop) const {
  return std::make_shared<const KeptModel>(reader_.read(upload.files, limits_, stop));
}

void ModelStore::check_rest(const std::string& id) {
  const std::lock_guard lock(mutex_);
  const Time* const died = deaths_.find(id);
  if (died != nullptr && now_() - *died < rest_after_death)
    throw ReaderDied("a reader has died of the model " + id + " within the hour");
}

void ModelStore::remember_death(const std::string& id) {
  LruMap<std::string, Time>::Entries old;
  const std::lock_guard lock(mutex_);
  deaths_.take(id, old);
  deaths_.add(id, now_());
  if (deaths_.size() > most_deaths) deaths_.take_last(old);
}

}  // namespace tia::server
