// The field along a path, by geometrical optics: a complex vector that each interaction changes in
// its own basis.
#pragma once

#include "core/radio/antenna.h"
#include "core/radio/radio_body.h"
#include "core/radio/radio_path.h"
#include "core/radio/wave_field.h"

namespace tia {

/// What is left of the field of unit amplitude after a reflection or a transmission; `in` and `out`
/// are the path's unit directions before and after it.
WaveField after(const RadioInteraction& at, const RadioBody& body, const LinkWave& link,
                const Vec3d& in, const Vec3d& out, const WaveField& field);

/// Sets a path's gain: by port pair lambda/(4 pi L) e^{-j k L} times what the interactions leave of
/// the transmitter's field along the receiver's. Source: radio.md, "Exactly".
void set_gain(RadioPath& path, const RadioBodies& all, const LinkWave& link,
              const Antenna& transmitter, const Antenna& receiver);

/// The mean over both antennas' ports of |gain|^2.
double power_of(const PathGain& gain, int receiver_ports, int transmitter_ports);

/// By how much the frequency is shifted, Hz: (v_t . d_t - v_r . d_r)/lambda, d the path's
/// directions where it leaves and where it arrives.
double doppler_of(const RadioPath& path, const LinkWave& link, const Antenna& transmitter,
                  const Antenna& receiver);

}  // namespace tia
