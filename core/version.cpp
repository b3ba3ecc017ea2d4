#include "core/version.h"

#include "core/film/png.h"

namespace tia {

std::string version() { return TIA_VERSION; }

std::string full_version() {
  std::string encoder = png_encoder();
  for (char& c : encoder)
    if (c == ' ') c = '-';
  return version() + "+" + encoder;
}

}  // namespace tia
