// The program that these tests are of.
#pragma once

#include <filesystem>
#include <string>

namespace tia::test {

/// Its path. They stand in its build's folder "tests".
inline std::string tia_program() {
  return (std::filesystem::canonical("/proc/self/exe").parent_path().parent_path() / "tia")
      .string();
}

}  // namespace tia::test
