#include "server/requests/film_frames.h"

#include <utility>

#include "core/accel/world/refit_geometry.h"
#include "server/operation/memory_costs.h"
#include "server/requests/studio.h"
#include "server/stores/scene_bytes.h"

namespace tia::server {

FilmFrames::FilmFrames(FilmRequest& asked, const KnownScene& scene)
    : asked_(asked), moving_(scene) {
  if (!scene->animation) return;
  moments_.emplace(*scene);
  if (!moments_->are_few()) moments_.reset();
}

KnownScene FilmFrames::scene_at(double seconds, const RenderContext& context,
                                const Requester& requester) {
  if (!moments_) return server::scene_at(moving_, seconds, asked_.along, context, requester);
  const std::size_t objects = parts_.digests.empty() ? moving_.objects.bytes : 0;
  return context.go_through(moving_.others + objects, requester, [&] {
    const Place all{};
    const auto made =
        std::make_shared<const Scene>(moments_->at(seconds, all.at("scene"), requester.stop));
    const auto [digest, bytes] = digest_by_parts(*made, moments_->moved(), parts_);
    return KnownScene{made, {digest, bytes}, bytes_besides_objects(*made), moving_.models};
  });
}

Plan FilmFrames::plan_at(double seconds, const RenderContext& context, const Requester& requester) {
  FoundScene found{moving_, {}, 0};
  if (moving_->animation) {
    asked_.time = seconds;
    found = {scene_at(seconds, context, requester), moving_, seconds};
  }
  Plan plan = plan_of(asked_, found, context, requester);
  plan.takes_codes = row_of(asked_.film_format).takes_codes;
  return plan;
}

Picture FilmFrames::draw(const Plan& plan, const RenderContext& context,
                         const std::stop_token& stop) {
  if (!moments_ || plan.exposure.blurs()) return server::draw(plan, context, stop);
  return Studio(plan, context, stop, nullptr).picture([&](const Workers& workers) {
    std::vector<World> worlds;
    worlds.push_back(world_of(plan, context, workers));
    return worlds;
  });
}

// The first one's is the store's, the second one has a copy, which is changed from then on. What
// cannot be changed is built anew, as the next one will have to be.
World FilmFrames::world_of(const Plan& plan, const RenderContext& context, const Workers& workers) {
  if (first_ && fit_to(plan.scene, workers)) {
    World world;
    workers.alone([&] { world = compile(*plan.scene, own_, workers); });
    return world;
  }
  const bool is_first = first_ == nullptr;
  World world = context.geometries.compile(plan.scene, workers);
  if (is_first) first_ = world.of_objects;
  else moments_.reset();
  return world;
}

bool FilmFrames::fit_to(const KnownScene& scene, const Workers& workers) {
  if (!own_)
    reserve_memory(memory_for(memory_cost::build, scene.objects.bytes + scene.models),
                   "what the objects compile to", workers.stop());
  bool fits = false;
  workers.alone([&] {
    if (!own_) own_ = std::make_shared<Geometry>(*first_);
    fits = refit(*own_, *scene, moments_->moved(), workers);
  });
  return fits;
}

}  // namespace tia::server
