// Files that nobody sees before they are whole: they have no name until then, and are gone with
// whoever writes them.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

namespace tia::server {

/// OpenFile: a descriptor, closed with its owner.
class OpenFile {
 public:
  explicit OpenFile(int number = -1) : number_(number) {}
  OpenFile(OpenFile&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(OpenFile other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~OpenFile();
  operator int() const { return number_; }

 private:
  int number_;
};

// What goes wrong with any of these calls: HttpError (storage-full) where the disk has no room,
// else StorageError.
[[noreturn]] void refuse_file(int error, const char* call);
std::int64_t size_of(const OpenFile& file);
/// All of it from its start, or as much as there is of so many bytes.
std::string read_file(const OpenFile& file, std::size_t bytes);

/// DiskRoom: how many bytes the files of a folder may have together. Any thread may call.
class DiskRoom {
 public:
  explicit DiskRoom(std::int64_t most) : most_(most) {}
  /// Errors: HttpError (storage-full).
  void take(std::int64_t bytes);
  /// Of files that are there, however many they are.
  void count(std::int64_t bytes) { used_ += bytes; }
  std::int64_t used() const { return used_; }

 private:
  const std::int64_t most_;
  std::atomic<std::int64_t> used_ = 0;
};

/// UnnamedFile: one that is being written. One thread at a time.
class UnnamedFile {
 public:
  /// It begins when its first byte comes. Domain: folder and room outlive it.
  UnnamedFile(int folder, DiskRoom& room) : folder_(folder), room_(room) {}
  ~UnnamedFile() { room_.count(-unnamed_); }
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  /// Errors: HttpError (storage-full); StorageError.
  void append(std::string_view bytes);
  std::size_t size() const { return size_; }
  /// What has been written, as the disk has it. Errors: StorageError.
  std::string contents() const;
  /// Gives it its name, once all of it is on the disk: what has one when this returns is there
  /// after any crash. Returns: false where that name is taken already. Errors: as append().
  bool publish(const std::string& name);

 private:
  void open();

  const int folder_;
  DiskRoom& room_;
  OpenFile file_;
  std::size_t size_ = 0;
  std::int64_t unnamed_ = 0;  // bytes of room that are lost with it
};

}  // namespace tia::server
