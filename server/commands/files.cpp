#include "server/commands/files.h"

#include <filesystem>
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
  FileToBe file(name);
  file.append(bytes);
  file.finish();
}

FileToBe::FileToBe(const std::string& name) : name_(name) {
  if (name_ == "-") return;
  file_.open(part(), std::ios::binary | std::ios::trunc);
  if (!file_) fail();
}

FileToBe::~FileToBe() {
  std::error_code none;
  if (name_ != "-" && !is_whole_ && std::filesystem::is_regular_file(part(), none))
    std::filesystem::remove(part(), none);
}

void FileToBe::fail() const {
  throw std::runtime_error("cannot write " + (name_ == "-" ? "to standard output" : name_));
}

void FileToBe::append(std::string_view bytes) {
  std::ostream& to = name_ == "-" ? std::cout : file_;
  to << bytes;
  if (!to) fail();
}

void FileToBe::finish() {
  if (name_ == "-") {
    if (!(std::cout << std::flush)) fail();
    return;
  }
  file_.close();
  std::error_code error;
  if (file_) std::filesystem::rename(part(), name_, error);
  if (!file_ || error) fail();
  is_whole_ = true;
}

}  // namespace tia::server
