// The file of kept scenes: SQLite, which alone knows how to survive a crash. The only place that
// includes it. Any thread may call, and any process of the machine may have the same file open.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

struct sqlite3;

namespace tia::server {

class SceneFile {
 public:
  static constexpr const char* name = "scenes.sqlite";

  /// Opens FOLDER/scenes.sqlite, or begins it, and looks through it.
  /// Errors: std::runtime_error for a folder that is not there or cannot be written to, a file that
  /// is damaged, or is another program's, or is full.
  SceneFile(const std::string& folder, std::int64_t max_bytes);
  ~SceneFile();

  /// Keeps a text by its id. What is kept when this returns is there after any crash.
  /// Errors: HttpError: storage-full where disk or file have no room, storage for all else.
  void keep(const std::string& id, const std::string& text);
  /// The text of that id, or nothing. Errors: HttpError (storage), for one that is damaged, too.
  std::optional<std::string> find(const std::string& id);
  /// What the file holds, as far as this process knows. Waits for nothing.
  std::int64_t bytes() const { return bytes_; }

 private:
  class Statement;
  void run(const char* sql);
  std::string word(const std::string& sql);
  void open(const std::string& path);
  void prepare(std::int64_t max_bytes);
  void share();
  void look_through();
  void measure();
  [[noreturn]] void fail() const;

  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::mutex mutex_;
  std::unique_ptr<sqlite3, Close> database_;
  std::atomic<std::int64_t> bytes_ = 0;
};

}  // namespace tia::server
