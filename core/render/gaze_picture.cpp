#include "core/render/gaze_picture.h"

#include <algorithm>

#include "core/scene/pixel_cone.h"

namespace tia {
namespace {

// Rings that are traced together: in the order of their turn, rays of four rings lie nearly in
// squares, so that packets meet fewer boxes than those along one ring.
constexpr std::size_t rings_of_band = 4;
// How many rays have their sums at once.
constexpr std::size_t most_targets = 512;
// No pixel is there, so that the random numbers of rings are their own.
constexpr std::uint32_t below_pictures = 1U << 25;

}  // namespace

GazePicture::GazePicture(const WindowTiles& tiles, const Shot& shot, Scalar scalar,
                         const Gaze& gaze)
    : tiles_(tiles),
      shot_(shot),
      scalar_(scalar),
      acuity_(gaze.acuity),
      frame_(shot.first().view, gaze.x, gaze.y),
      fovea_(frame_, acuity_, tiles.window()),
      rings_(frame_, acuity_, fovea_, tiles.window()),
      samples_(static_cast<std::size_t>(rings_.rays())) {}

void GazePicture::draw(const WindowTiles::Develop& develop, Tally& tally) {
  tiles_.share().for_each(static_cast<int>(bands()),
                          [&](int band) { trace_band(static_cast<std::size_t>(band), tally); });
  const GazeFilling filling{frame_,   fovea_,        rings_,
                            samples_, acuity_.slope, !gathers_light(shot_.integrator)};
  tiles_.for_each_tile([&](int, FilmTile& tile) {
    fill_from_rings(filling, tiles_.window().x0, tiles_.window().y0, tile);
    trace_fovea(tile, tally);
    tiles_.hand_over(develop, tile);
  });
}

// ---- rings --------------------------------------------------------------------------------------

std::size_t GazePicture::bands() const {
  return (rings_.rings().size() + rings_of_band - 1) / rings_of_band;
}

std::vector<GazePicture::RayOfRing> GazePicture::rays_of_band(std::size_t band) const {
  const std::vector<GazeRing>& rings = rings_.rings();
  std::vector<RayOfRing> rays;
  const std::size_t end = std::min((band + 1) * rings_of_band, rings.size());
  for (std::size_t k = band * rings_of_band; k < end; ++k)
    for (const Arc& arc : rings[k].arcs)
      for (int i = arc.begin; i < arc.end; ++i) {
        const double turn = rings[k].start + static_cast<double>(i) / rings[k].count;
        rays.push_back({turn < 1 ? turn : turn - 1, &rings[k], i, arc.slot + i - arc.begin});
      }
  std::ranges::sort(rays, {}, &RayOfRing::turn);
  return rays;
}

// Of several rays beside it, within a square of the smallest angle that is seen there.
Target GazePicture::target_of(const RayOfRing& ray) const {
  const auto [direction, outwards, along] = frame_.place(ray.ring->eccentricity, ray.turn);
  return {direction, along * ray.ring->width, outwards * ray.ring->width,
          static_cast<std::uint32_t>(ray.ray),
          below_pictures + static_cast<std::uint32_t>(ray.ring - rings_.rings().data())};
}

// What a ray sees of textures is as wide as what is seen at the innermost ring of its band.
double GazePicture::spread_of(std::size_t band) const {
  return std::max(rings_.rings()[band * rings_of_band].width, cone_of(shot_.first().view).spread);
}

void GazePicture::trace_band(std::size_t band, Tally& tally) {
  const std::vector<RayOfRing> rays = rays_of_band(band);
  for (std::size_t begin = 0; begin < rays.size(); begin += most_targets) {
    const std::size_t end = std::min(begin + most_targets, rays.size());
    TilePixels pixels{0, 0, static_cast<int>(end - begin), 1};
    pixels.spread = spread_of(band);
    for (std::size_t i = begin; i < end; ++i) pixels.targets.push_back(target_of(rays[i]));
    const ShownTile shown = traced(pixels, tally);
    for (std::size_t i = begin; i < end; ++i) {
      const Shown& each = shown.pixels[i - begin];
      samples_[static_cast<std::size_t>(rays[i].slot)] = {
          {each.light.x, each.light.y, each.light.z, each.alpha}};
    }
  }
}

// ---- the fovea ----------------------------------------------------------------------------------

bool GazePicture::is_of_fovea(const TilePixels& tile, int pixel) const {
  return fovea_.has(tile.x0 + pixel % tile.width, tile.y0 + pixel / tile.width, acuity_.slope);
}

void GazePicture::trace_fovea(FilmTile& tile, Tally& tally) const {
  TilePixels pixels = tiles_.pixels_of(tile, false, false);
  if (!overlap(fovea_.box(),
               {pixels.x0, pixels.y0, pixels.x0 + pixels.width, pixels.y0 + pixels.height}))
    return;
  pixels.begin();
  std::erase_if(pixels.unsettled, [&](int pixel) { return !is_of_fovea(pixels, pixel); });
  const std::vector<int> own = pixels.unsettled;
  if (own.empty()) return;
  trace_rounds(shot_, scalar_, 0, shot_.sampler.rounds(), pixels);
  ShownTile shown;
  for (const int pixel : own) {
    const Shown of = shown_of(pixels.estimates[static_cast<std::size_t>(pixel)]);
    const std::size_t at = FilmTile::index(pixel % tile.width, pixel / tile.width);
    tile.r[at] = of.light.x, tile.g[at] = of.light.y, tile.b[at] = of.light.z;
    tile.alpha[at] = of.alpha;
    shown.pixels.push_back(of);
  }
  shown.error = pixels.error;
  tally.add(shown);
}

ShownTile GazePicture::traced(TilePixels& pixels, Tally& tally) const {
  trace_rounds(shot_, scalar_, 0, shot_.sampler.rounds(), pixels);
  ShownTile shown = shown_of(pixels, {});
  tally.add(shown);
  return shown;
}

}  // namespace tia
