// A scene's bodies as radio waves meet them, and the flat ones' facets.
#pragma once

#include <string>
#include <vector>

#include "core/radio/facet.h"
#include "core/radio/permittivity.h"
#include "core/radio/radio_edge.h"

namespace tia {

/// RadioBody: an object that waves meet.
struct RadioBody {
  std::string name;            ///< as answers call it (labels.h)
  std::string_view type = {};  ///< of its shape
  RadioMatter matter{};
  bool sheet = false;  ///< an open surface, `thickness` thick: else a body, or a half space
  bool flat = true;    ///< whether it is all facets: else it is curved, or known to the world only
  double thickness = 0;  ///< metres, of a sheet

  bool is_air() const { return matter.kind == RadioMatter::air; }
  /// Whether waves may go on behind it.
  bool lets_through() const {
    return matter.kind == RadioMatter::dielectric && (sheet || matter.through);
  }
};

/// RadioBodies. Their numbers are those of the world's objects (labels.h).
struct RadioBodies {
  static constexpr std::size_t most_facets = 1 << 18;
  std::vector<RadioBody> bodies;
  std::vector<Facet> facets;
  std::vector<FacetPiece> pieces;  ///< facet by facet
  std::vector<RadioEdge> edges{};  ///< of the facets; none before the world is made
  std::vector<std::string> assumed, warnings;
};

}  // namespace tia
