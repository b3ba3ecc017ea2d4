#include "server/files.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace tia::server {

std::string read_file(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw std::runtime_error("cannot read " + name);
  return text.str();
}

void write_file(const std::string& name, const std::string& bytes) {
  if (name == "-") {
    std::cout << bytes << std::flush;
    if (!std::cout) throw std::runtime_error("cannot write to standard output");
    return;
  }
  std::ofstream file(name, std::ios::binary | std::ios::trunc);
  file << bytes;
  file.close();
  if (file) return;
  std::error_code none;  // half a picture is none
  if (std::filesystem::is_regular_file(name, none)) std::filesystem::remove(name, none);
  throw std::runtime_error("cannot write " + name);
}

void replace_file(const std::string& name, const std::string& bytes) {
  const std::string part = name + ".part";
  write_file(part, bytes);
  std::error_code error;
  std::filesystem::rename(part, name, error);
  if (!error) return;
  std::filesystem::remove(part, error);
  throw std::runtime_error("cannot write " + name);
}

}  // namespace tia::server
