// Diffraction by edges, of the first order: the uniform theory.
#pragma once

#include <optional>

#include "core/radio/fresnel.h"
#include "core/radio/radio_body.h"
#include "core/radio/radio_edge.h"
#include "core/radio/radio_path.h"
#include "core/radio/wave_field.h"

namespace tia {

/// F(x) = 2 j sqrt(x) e^{jx} times the integral of e^{-j t^2} from sqrt(x) to infinity, which makes
/// the field continuous where rays begin or end. `root`: the root of x, >= 0.
/// Returns: within 1e-11. Source: Kouyoumjian, Pathak, "A uniform geometrical theory of diffraction
/// for an edge in a perfectly conducting surface", Proc. IEEE 62 (1974), (27).
Complex transition(double root);

/// EdgeWay: a way around an edge. Space/units: metres, radians.
struct EdgeWay {
  double incident = 0, diffracted = 0;  ///< phi' and phi, from face 0
  double sine = 1;                      ///< of the angle between the way and the edge
  double before = 1, behind = 1;        ///< s' and s
};
/// The coefficients of the field along the edge (`perpendicular`: soft) and across it (`parallel`:
/// hard), in roots of metres. Source: Kouyoumjian, Pathak, (25) to (29); of faces that are no
/// conductors the terms of reflection are multiplied as Luebbers, "Finite conductivity uniform GTD
/// versus knife edge diffraction", IEEE Trans. AP-32 (1984), has it, but at the angle whose sine is
/// the mean (geometric) of both sides', so that both ways are the same.
Polarized edge_coefficients(const EdgeWay& way, double n, const RadioBody& body, const Wave& wave);

/// The way around an edge, by Fermat's principle: it meets the edge at the same angle on both
/// sides. None where that is beyond the edge's ends, or on the body's inner side.
std::optional<RadioPath> edge_path(const RadioEdge& edge, int number, const Vec3d& from,
                                   const Vec3d& to);

/// What is left of a field at an edge; `at` is of an edge_path.
WaveField after_edge(const RadioInteraction& at, const RadioEdge& edge, const RadioPath& path,
                     const RadioBody& body, const LinkWave& link, const WaveField& field);

}  // namespace tia
