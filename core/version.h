// What this build is. The same version gives the same bytes.
#pragma once

#include <string>

namespace tia {

/// "0.4.2"
std::string version();
/// The version and everything else that a PNG's bytes depend on: "0.4.2+libdeflate-1.14".
std::string full_version();

}  // namespace tia
