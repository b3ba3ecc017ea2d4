#include "tests/bench/rays/tracers.h"

#ifdef TIA_HAS_EMBREE
#include <embree3/rtcore.h>
#include <pmmintrin.h>
#include <xmmintrin.h>

#include <algorithm>
#include <atomic>
#include <chrono>

namespace tia::bench {
namespace {

// Embree's manual asks for both modes; Tia's results are those without.
class DenormalsAreZero {
 public:
  DenormalsAreZero() { _mm_setcsr(before_ | _MM_FLUSH_ZERO_ON | _MM_DENORMALS_ZERO_ON); }
  ~DenormalsAreZero() { _mm_setcsr(before_); }
  DenormalsAreZero(const DenormalsAreZero&) = delete;
  DenormalsAreZero& operator=(const DenormalsAreZero&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
};

bool count_bytes(void* sum, ssize_t bytes, bool) {
  *static_cast<std::atomic<ssize_t>*>(sum) += bytes;
  return true;
}

void share(RTCGeometry to, RTCBufferType type, RTCFormat format, const void* from,
           std::size_t stride, std::size_t count) {
  rtcSetSharedGeometryBuffer(to, type, 0, format, from, 0, stride, count);
}

RTCGeometry geometry_of(RTCDevice device, const Geometry& from) {
  if (!from.spheres.empty()) {
    RTCGeometry to = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    share(to, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, from.spheres.data(), 16,
          from.spheres.size() / 4);
    return to;
  }
  RTCGeometry to = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  share(to, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, from.positions.data(), 12,
        from.positions.size() / 3);
  share(to, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, from.indices.data(), 12,
        from.indices.size() / 3);
  return to;
}

RTCIntersectContext context_of(const RaySet& rays) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (rays.coherent()) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  return context;
}

constexpr std::size_t packet = 8;

RTCRay8 load_packet(const RaySet& rays, std::size_t i) {
  RTCRay8 ray;
  const auto copy = [&](const std::vector<float>& from, float* to) {
    std::copy_n(&from[i], packet, to);
  };
  copy(rays.origin[0], ray.org_x), copy(rays.origin[1], ray.org_y);
  copy(rays.origin[2], ray.org_z), copy(rays.direction[0], ray.dir_x);
  copy(rays.direction[1], ray.dir_y), copy(rays.direction[2], ray.dir_z);
  copy(rays.t_max, ray.tfar);
  std::fill_n(ray.tnear, packet, 0.0F);
  std::fill_n(ray.time, packet, 0.0F);
  std::fill_n(ray.mask, packet, ~0U);
  std::fill_n(ray.flags, packet, 0U);
  return ray;
}

RTCRay load_ray(const RaySet& rays, std::size_t i) {
  RTCRay ray{};
  ray.org_x = rays.origin[0][i], ray.org_y = rays.origin[1][i], ray.org_z = rays.origin[2][i];
  ray.dir_x = rays.direction[0][i], ray.dir_y = rays.direction[1][i];
  ray.dir_z = rays.direction[2][i];
  ray.tfar = rays.t_max[i];
  ray.mask = ~0U;
  return ray;
}

// Embree sets tfar of a ray that is blocked to -infinity.
float blocked_or_not(float tfar) { return tfar < 0 ? 0 : infinity; }

}  // namespace

struct EmbreeDevice {
  std::atomic<ssize_t> bytes = 0;
  RTCDevice device = nullptr;

  explicit EmbreeDevice(const std::string& config) : device(rtcNewDevice(config.c_str())) {
    rtcSetDeviceMemoryMonitorFunction(device, count_bytes, &bytes);
  }
  ~EmbreeDevice() { rtcReleaseDevice(device); }
  EmbreeDevice(const EmbreeDevice&) = delete;
  EmbreeDevice& operator=(const EmbreeDevice&) = delete;
};

std::shared_ptr<EmbreeDevice> embree_device(int threads, const std::string& isa) {
  const DenormalsAreZero mode;  // for its threads, too
  const std::string chosen = isa.empty() ? "" : ",isa=" + isa;
  return std::make_shared<EmbreeDevice>("threads=" + std::to_string(threads) + chosen);
}

struct EmbreeIndex::Handles {
  RTCScene scene = nullptr;
};

EmbreeIndex::EmbreeIndex(const Geometry& geometry, std::shared_ptr<EmbreeDevice> device)
    : device_(std::move(device)), handles_(std::make_unique<Handles>()) {
  const DenormalsAreZero mode;
  const ssize_t before = device_->bytes;
  const auto start = std::chrono::steady_clock::now();
  handles_->scene = rtcNewScene(device_->device);
  RTCGeometry shape = geometry_of(device_->device, geometry);
  rtcCommitGeometry(shape);
  rtcAttachGeometry(handles_->scene, shape);
  rtcReleaseGeometry(shape);
  rtcCommitScene(handles_->scene);
  const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
  const std::size_t shared =
      geometry.spheres.size() + geometry.positions.size() + geometry.indices.size();
  built_ = {took.count(),
            static_cast<double>(device_->bytes - before) + 4.0 * static_cast<double>(shared)};
}

EmbreeIndex::~EmbreeIndex() { rtcReleaseScene(handles_->scene); }

void EmbreeIndex::trace_packets(const RaySet& rays, Answers& answers) const {
  const DenormalsAreZero mode;
  RTCIntersectContext context = context_of(rays);
  for (std::size_t i = 0; i < rays.size(); i += packet) {
    alignas(32) int valid[packet];
    bool some = false;
    for (std::size_t k = 0; k < packet; ++k) {
      valid[k] = rays.t_max[i + k] >= 0 ? -1 : 0;
      some = some || valid[k] != 0;
    }
    if (!some) continue;
    RTCRayHit8 at;
    at.ray = load_packet(rays, i);
    if (rays.any_hit()) {
      rtcOccluded8(valid, handles_->scene, &context, &at.ray);
      for (std::size_t k = 0; k < packet; ++k) answers[i + k] = blocked_or_not(at.ray.tfar[k]);
    } else {
      std::fill_n(at.hit.geomID, packet, RTC_INVALID_GEOMETRY_ID);
      std::fill_n(at.hit.instID[0], packet, RTC_INVALID_GEOMETRY_ID);
      rtcIntersect8(valid, handles_->scene, &context, &at);
      std::copy_n(at.ray.tfar, packet, &answers[i]);
    }
  }
}

void EmbreeIndex::trace_single(const RaySet& rays, Answers& answers) const {
  const DenormalsAreZero mode;
  RTCIntersectContext context = context_of(rays);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays.t_max[i] < 0) continue;
    RTCRayHit at;
    at.ray = load_ray(rays, i);
    if (rays.any_hit()) {
      rtcOccluded1(handles_->scene, &context, &at.ray);
      answers[i] = blocked_or_not(at.ray.tfar);
    } else {
      at.hit.geomID = at.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      rtcIntersect1(handles_->scene, &context, &at);
      answers[i] = at.ray.tfar;
    }
  }
}

}  // namespace tia::bench
#endif
