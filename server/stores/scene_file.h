// The file of kept scenes. Any thread may call, and any process of the machine may have the same
// file open.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "server/stores/database.h"

namespace tia::server {

/// Owner: who keeps a scene.
struct Owner {
  std::string client;       ///< by what clients' shares are counted
  std::string key_hash;     ///< SHA-256 of the key with which it may be deleted, or ""
  std::int64_t time_s = 0;  ///< when, in seconds of Unix
};
/// A scene that more have kept tells the next ones no key.
inline constexpr int most_owners = 64;

/// Removal: what became of a wish to delete a scene.
enum class Removal { done, unknown, forbidden };

class SceneFile {
 public:
  static constexpr const char* name = "scenes.sqlite";

  /// Opens FOLDER/scenes.sqlite, or begins it, and looks through it.
  /// Errors: std::runtime_error for a folder that is not there or cannot be written to, a file that
  /// is damaged, or is another program's, or is full.
  SceneFile(const std::string& folder, std::int64_t max_bytes);

  /// Keeps a text by its id, and that its owner may delete it. What is kept when this returns is
  /// there after any crash.
  /// Errors: HttpError: storage-full where disk or file have no room, or the owner's client has
  /// half of the file already; storage for all else.
  void keep(const std::string& id, const std::string& text, const Owner& owner = {});
  /// The text of that id, or nothing. Errors: HttpError (storage), for one that is damaged, too.
  std::optional<std::string> find(const std::string& id);
  /// Whether there is one. Errors: HttpError (storage).
  bool contains(const std::string& id);
  /// That somebody uses it now. Errors: HttpError (storage).
  void touch(const std::string& id, std::int64_t now_s);
  /// Takes the owner of that key off it; it goes with its last one. Errors: HttpError (storage).
  Removal remove(const std::string& id, const std::string& key_hash);
  bool knows_owner(const std::string& id, const std::string& key_hash);
  /// Forgets what nobody has used since. Errors: HttpError (storage).
  void forget_unused_since(std::int64_t time_s);
  /// What the file holds, as far as this process knows. Waits for nothing.
  std::int64_t bytes() const { return bytes_; }

 private:
  void prepare(std::int64_t max_bytes);
  void lay_out(const std::string& version);
  void check_share(const std::string& id, const std::string& text, const Owner& owner);
  void share();
  void look_through();
  void measure();

  std::mutex mutex_;
  std::optional<Database> database_;  // there, once this is made
  std::int64_t max_bytes_ = 0;
  std::atomic<std::int64_t> bytes_ = 0;
};

}  // namespace tia::server
