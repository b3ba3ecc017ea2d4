#include "core/radio/path_field.h"

#include "core/math/onb.h"
#include "core/math/powers.h"
#include "core/radio/diffraction.h"
#include "core/radio/fresnel.h"

namespace tia {
namespace {

Vec3d way_between(const Vec3d& a, const Vec3d& b) { return unit(b - a); }

Polarized reflected(const RadioInteraction& at, const RadioBody& body, const LinkWave& link) {
  if (body.matter.kind == RadioMatter::conductor) return mirrored;
  if (body.sheet) return sheet(body.matter.eta, at.cosine, body.thickness, link.wave).reflected;
  return half_space(body.matter.eta, at.cosine);
}

// Of a body the entrance, or the exit, each with half of the way inside.
Polarized transmitted(const RadioInteraction& at, const RadioBody& body, const LinkWave& link) {
  if (body.sheet) return sheet(body.matter.eta, at.cosine, body.thickness, link.wave).transmitted;
  const Polarized door = half_space_through(body.matter.eta, at.cosine);
  const double layer = link.wave.number() * at.inside * link.unit_metres * at.cosine / 2;
  const Complex phase = excess_of(body.matter.eta, at.cosine) * layer;
  const Complex way = turn(-phase.re) * exp_of(phase.im);
  return {door.perpendicular * way, door.parallel * way};
}

}  // namespace

WaveField after(const RadioInteraction& at, const RadioBody& body, const LinkWave& link,
                const Vec3d& in, const Vec3d& out, const WaveField& field) {
  const Polarized factor =
      at.kind == RadioKind::reflection ? reflected(at, body, link) : transmitted(at, body, link);
  const Vec3d across = cross(in, at.normal);
  // Straight on, any direction is perpendicular to the plane of incidence.
  const Vec3d s = dot(across, across) > 1e-24 ? unit(across) : onb_around(in).u;
  WaveField left;
  left.add(s, factor.perpendicular * field.along(s));
  left.add(cross(s, out), factor.parallel * field.along(cross(s, in)));
  return left;
}

void set_gain(RadioPath& path, const RadioBodies& all, const LinkWave& link,
              const Antenna& transmitter, const Antenna& receiver) {
  const Vec3d away = way_between(path.from, path.second());
  const AntennaPorts sent = ports_of(transmitter, away);
  const AntennaPorts taken = ports_of(receiver, way_between(path.to, path.last_but_one()));
  const double metres = path.length * link.unit_metres;
  const double tube = path.tube > 0 ? path.tube * link.unit_metres : metres;
  const Complex spread = turn(-link.wave.number() * metres + path.caustics * (pi / 2)) *
                         (link.wave.length() / (4 * pi * tube));
  for (std::size_t t = 0; t < static_cast<std::size_t>(sent.count); ++t) {
    WaveField field{sent.field[t], {}};
    Vec3d in = away;
    for (std::size_t i = 0; i < path.interactions.size(); ++i) {
      const RadioInteraction& at = path.interactions[i];
      const bool last = i + 1 == path.interactions.size();
      // Straight on through a wall, also where the next one touches it: their points are the same.
      const Vec3d out =
          at.kind == RadioKind::transmission
              ? in
              : way_between(at.point, last ? path.to : path.interactions[i + 1].point);
      const RadioBody& body = all.bodies[static_cast<std::size_t>(at.body)];
      if (at.kind == RadioKind::diffraction)
        field =
            after_edge(at, all.edges[static_cast<std::size_t>(at.edge)], path, body, link, field);
      else field = after(at, body, link, in, out, field);
      in = out;
    }
    for (std::size_t r = 0; r < static_cast<std::size_t>(taken.count); ++r)
      path.gain[r][t] = field.along(taken.field[r]) * spread;
  }
}

double power_of(const PathGain& gain, int receiver_ports, int transmitter_ports) {
  double sum = 0;
  for (std::size_t r = 0; r < static_cast<std::size_t>(receiver_ports); ++r)
    for (std::size_t t = 0; t < static_cast<std::size_t>(transmitter_ports); ++t)
      sum += norm_of(gain[r][t]);
  return sum / (receiver_ports * transmitter_ports);
}

double doppler_of(const RadioPath& path, const LinkWave& link, const Antenna& transmitter,
                  const Antenna& receiver) {
  const double leaving = dot(transmitter.velocity, way_between(path.from, path.second()));
  const double arriving = dot(receiver.velocity, way_between(path.last_but_one(), path.to));
  return (leaving - arriving) / link.wave.length();
}

}  // namespace tia
