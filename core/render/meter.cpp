#include "core/render/meter.h"

#include <utility>

#include "core/parallel/stopped.h"
#include "core/scene/limits.h"

namespace tia {

void RayMeter::add(RayCounts& rays) {
  const RayCounts more = std::exchange(rays, {});
  primary_ += more.primary;
  shadow_ += more.shadow;
  reflection_ += more.reflection;
  refraction_ += more.refraction;
  cut_ += more.cut;
  const std::int64_t spent = more.all();
  if (all_.fetch_add(spent) + spent <= max_rays_) return tell();
  const bool deep = reflection_ + refraction_ > all_ / 2;
  throw deep ? too_many_children(max_rays_) : too_many_rays("a picture of more", max_rays_);
}

void RayMeter::add_work(std::int64_t work) {
  end_if_asked(stop_);
  if (work_.fetch_add(work) + work > max_work_) throw too_much_work(max_work_);
  tell();
}

void RayMeter::add_many(RayCounts& rays) {
  end_if_asked(stop_);
  add(rays);
}

}  // namespace tia
