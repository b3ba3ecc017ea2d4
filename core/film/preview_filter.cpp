#include "core/film/preview_filter.h"

#include <cstdlib>
#include <utility>

#include "core/film/denoise_albedo.h"
#include "core/film/denoise_weights.h"
#include "core/math/lanes.h"

namespace tia {
namespace {

constexpr int preview_passes = 5;
constexpr int preview_reach = 2 << (preview_passes - 1);

// The cubic B-spline, in both directions. Of its 25 places the outer 12 have a seventh of the
// weight together: they are left out.
float spline(int dx, int dy) {
  constexpr std::array<float, 3> share{0.375F, 0.25F, 0.0625F};
  return share[static_cast<std::size_t>(std::abs(dx))] *
         share[static_cast<std::size_t>(std::abs(dy))];
}

/// PreviewFilter: of one picture.
class PreviewFilter {
 public:
  PreviewFilter(const PixelPlanes& pixels, const Workers& workers)
      : pixels_(pixels),
        workers_(workers),
        grid_(0, 0, pixels.width, pixels.height, preview_reach),
        inside_(window_of(grid_)),
        light_(over_albedo(grid_, pixels, inside_, workers)) {
    workers.for_each(static_cast<int>(guides_.size()), [this](int guide) {
      const auto i = static_cast<std::size_t>(guide);
      guides_[i] = padded(grid_, pixels_.planes[PixelPlanes::normal + i]);
    });
  }

  Image filtered() {
    std::array<TilePlane, 3> next = light_;
    for (int pass = 0; pass < preview_passes; ++pass) {
      for_each_tile(grid_, workers_, false, [&](int x, int y) {
        for (int row = 0; row < TileGrid::tile; ++row) filter(pass, grid_.at(x, y + row), next);
      });
      std::swap(light_, next);
    }
    return multiplied();
  }

 private:
  /// Pixels: some that stand side by side, one in each lane.
  struct Pixels {
    Vec3<Wide> light, normal;
    Wide depth, visibility;
  };
  Pixels pixels_at(std::size_t p) const {
    const auto of = [p](const TilePlane& plane) { return load<Wide>(plane.data() + p); };
    return {{of(light_[0]), of(light_[1]), of(light_[2])},
            {of(guides_[0]), of(guides_[1]), of(guides_[2])},
            of(guides_[3]),
            of(guides_[4])};
  }

  // A row of a tile, from the pixel p on.
  void filter(int pass, std::size_t p, std::array<TilePlane, 3>& to) const {
    for (const std::size_t end = p + TileGrid::tile; p < end; p += Wide::size) {
      const Vec3<Wide> light = filtered(pass, p);
      store(light.x, to[0].data() + p);
      store(light.y, to[1].data() + p);
      store(light.z, to[2].data() + p);
    }
  }
  Vec3<Wide> filtered(int pass, std::size_t p) const {
    const Pixels here = pixels_at(p);
    const Wide per_light(0.25F * static_cast<float>(1 << pass));
    const int step = 1 << pass;
    Wide all(0);
    Vec3<Wide> sum{Wide(0), Wide(0), Wide(0)};
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = std::abs(dy) - 2; dx <= 2 - std::abs(dy); ++dx) {
        const auto q = p + static_cast<std::size_t>(grid_.step(dx * step, dy * step));
        const Pixels there = pixels_at(q);
        const Wide weight = wide_weight(distance(here, there, per_light)) *
                            (Wide(spline(dx, dy)) * load<Wide>(inside_.data() + q));
        all = all + weight;
        sum = sum + there.light * weight;
      }
    return select(all > Wide(0), sum * (Wide(1) / all), here.light);
  }
  // A normal may turn, and a depth change by its share, by a tenth before that counts as much as
  // a change of visibility by half, or of light by what the pass allows. The shares of depth and of
  // light are added by one division.
  static Wide distance(const Pixels& a, const Pixels& b, const Wide& per_light) {
    const Vec3<Wide> turn = a.normal - b.normal, change = a.light - b.light;
    const Wide farther = a.depth - b.depth, hidden = a.visibility - b.visibility;
    const Wide depth = a.depth * a.depth + b.depth * b.depth + Wide(1e-15F);
    const Wide light = dot(a.light, a.light) + dot(b.light, b.light) + Wide(1e-15F);
    const Wide shares =
        dot(change, change) * per_light * depth + farther * farther * Wide(100) * light;
    return dot(turn, turn) * Wide(100) + hidden * hidden * Wide(4) + shares / (depth * light);
  }

  Image multiplied() const {
    Image image(grid_.width, grid_.height);
    workers_.for_each(grid_.height, [&](int y) {
      std::size_t pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width);
      for (int x = 0; x < grid_.width; ++x, ++pixel)
        for (std::size_t c = 0; c < 3; ++c)
          image.at(x, y)[c] = light_[c][grid_.at(x, y)] *
                              divisor_of(pixels_.planes[PixelPlanes::albedo + c][pixel]);
    });
    return image;
  }

  const PixelPlanes& pixels_;
  const Workers& workers_;
  const TileGrid grid_;
  TilePlane inside_;
  std::array<TilePlane, 3> light_;
  std::array<TilePlane, 5> guides_;  // normal, depth, visibility
};

}  // namespace

Image preview(const PixelPlanes& pixels, const Workers& workers) {
  return PreviewFilter(pixels, workers).filtered();
}

}  // namespace tia
