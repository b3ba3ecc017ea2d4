#include "server/handlers/backend.h"

#include <utility>

namespace tia::server {
namespace {

Admission::Options admission_options(const Config& config) {
  // Half of the time that a request has: the other half is for light work beside it.
  const double most_wait_s = config.deadline_ms / 2000.0;
  return {config.renders, config.queue, config.threads, most_wait_s};
}

ModelReader model_reader(const Config& config, const std::string& program) {
  return ModelReader({.memory_bytes = static_cast<std::uint64_t>(config.model_memory_bytes)},
                     program);
}

}  // namespace

Backend::Backend(const Config& given, const Gallery& gallery, DataFiles files,
                 const std::string& reader)
    : config(given),
      memory(config.memory_bytes),
      kept(config.max_scenes_bytes, std::move(files.scenes)),
      admission(admission_options(config)),
      pool(config.threads),
      geometries(config.max_geometry_bytes, &memory),
      pressed(config.max_scenes_bytes, long_work, memory),
      pictures(config.cache_bytes, &memory),
      models(model_reader(config, reader), {config.max_models_bytes, config.model_limits()},
             {memory, long_work, metrics}, std::move(files.models)),
      access(config, metrics, system_time, std::move(files.quotas)),
      jobs(files.jobs ? std::move(files.jobs) : job_store_in_memory(config), config,
           {gallery, kept, geometries, pressed, pool, long_work, config.limits(), &models}, costs,
           pictures, access, metrics, memory),
      live(config.streams),
      service{config,
              {gallery,
               kept,
               geometries,
               pressed,
               pool,
               long_work,
               config.limits(),
               &models,
               {config.ffmpeg, static_cast<unsigned>(config.film_deadline_ms / 1000 + 1)}},
              memory,
              admission,
              costs,
              metrics,
              pictures,
              models,
              access,
              jobs,
              live} {
  kept.book_with(memory);
  kept.read_as(long_work, config.json_limits().values);
  kept.forget_after(config.scene_keep_s);
  // Under shortage what is cheapest to make again goes first.
  memory.on_shortage([this](std::int64_t bytes) { return pictures.give_way(bytes); });
  memory.on_shortage([this](std::int64_t bytes) { return geometries.give_way(bytes); });
  memory.on_shortage([this](std::int64_t bytes) { return models.give_way(bytes); });
  memory.on_shortage([this](std::int64_t bytes) { return pressed.give_way(bytes); });
}

}  // namespace tia::server
