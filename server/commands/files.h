// Files of the command line's.
#pragma once

#include <fstream>
#include <string>
#include <string_view>

namespace tia::server {

/// Errors: std::runtime_error naming it.
std::string read_file(const std::string& name);
/// To standard output where the name is "-". What cannot be written whole is removed.
/// Errors: std::runtime_error naming it.
void write_file(const std::string& name, const std::string& bytes);
/// Puts it in a file's place at once, so that whoever reads that finds one of the two whole.
/// Domain: a file beside which there may be another, NAME.part. Errors: as write_file.
void replace_file(const std::string& name, const std::string& bytes);

/// FileToBe: one that is written piece by piece beside its place, as NAME.part, and put there once
/// it is whole; until then the place holds what it held. "-" is standard output.
class FileToBe {
 public:
  /// Errors: std::runtime_error naming the file; also of the others.
  explicit FileToBe(const std::string& name);
  /// What is not whole is removed.
  ~FileToBe();
  FileToBe(const FileToBe&) = delete;
  FileToBe& operator=(const FileToBe&) = delete;

  void append(std::string_view bytes);
  void finish();

 private:
  std::string part() const { return name_ + ".part"; }
  [[noreturn]] void fail() const;

  const std::string name_;
  std::ofstream file_;
  bool is_whole_ = false;
};

}  // namespace tia::server
