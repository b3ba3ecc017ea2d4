#include "server/stores/scene_file.h"

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "server/contract/problem.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

constexpr int application_id = 0x54696100;  // "Tia", in the file's header, as file(1) shows it
constexpr int layout_version = 2;           // 1 knew no owners and no times
constexpr int timeout_ms = 5000;            // with another process that is writing

// What SQLite says goes to the log only, for it may tell of the machine; clients get the problem.
[[noreturn]] void refuse(const DatabaseError& error) {
  if (error.kind == DatabaseError::full)
    throw HttpError("storage-full",
                    "the file of kept scenes is full (option TIA_MAX_DATA_BYTES), or the disk is");
  throw StorageError(std::string("the file of kept scenes: ") + error.what());
}

// What is wrong with the file itself.
[[noreturn]] void reject(const std::string& text) {
  throw DatabaseError(DatabaseError::other, text);
}

}  // namespace

SceneFile::SceneFile(const std::string& folder, std::int64_t max_bytes) : max_bytes_(max_bytes) {
  const std::string path = folder + "/" + name;
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw std::runtime_error("option TIA_DATA_DIR: got " + folder +
                             ", allowed: a folder that is there and can be written to");
  try {
    database_.emplace(path, timeout_ms);
    prepare(max_bytes);
  } catch (const DatabaseError& error) {
    throw std::runtime_error("option TIA_DATA_DIR: " + path + ": " + error.what());
  }
}

// All that can be wrong with the file comes to light here: it is written to even if nothing is new.
void SceneFile::prepare(std::int64_t max_bytes) {
  database_->run(
      "BEGIN");  // else another process may begin the file between one answer and the next
  const std::string of = database_->word("PRAGMA application_id"),
                    is = database_->word("PRAGMA user_version");
  const bool is_new = database_->word("SELECT count(*) FROM sqlite_schema") == "0";
  database_->run("COMMIT");
  if (!is_new && of != std::to_string(application_id)) reject("this is another program's file");
  if (!is_new && is != std::to_string(layout_version) && is != "1")
    reject("another version of Tia has written this file");
  if (!is_new) look_through();
  share();
  database_->run("PRAGMA synchronous = FULL");  // a commit is on the disk before it is told
  database_->run("PRAGMA temp_store = MEMORY");
  database_->run("PRAGMA journal_size_limit = 8388608");
  const std::int64_t pages = max_bytes / std::stoll(database_->word("PRAGMA page_size"));
  database_->run("PRAGMA max_page_count = " + std::to_string(pages));
  database_->run("BEGIN IMMEDIATE");
  lay_out(database_->word("PRAGMA user_version"));
  database_->run("PRAGMA application_id = " + std::to_string(application_id));
  database_->run("PRAGMA user_version = " + std::to_string(layout_version));
  database_->run("COMMIT");
  measure();
}

// What version 1 has kept belongs to nobody: it can only fall out of use, from now on.
void SceneFile::lay_out(const std::string& version) {
  database_->run(
      "CREATE TABLE IF NOT EXISTS scenes (id TEXT PRIMARY KEY NOT NULL, text TEXT NOT NULL, "
      "client TEXT NOT NULL DEFAULT '', used INTEGER NOT NULL DEFAULT 0, "
      "bytes INTEGER NOT NULL DEFAULT 0)");
  if (version == "1") {
    database_->run("ALTER TABLE scenes ADD COLUMN client TEXT NOT NULL DEFAULT ''");
    database_->run("ALTER TABLE scenes ADD COLUMN used INTEGER NOT NULL DEFAULT 0");
    database_->run("ALTER TABLE scenes ADD COLUMN bytes INTEGER NOT NULL DEFAULT 0");
    database_->run(
        "UPDATE scenes SET used = CAST(strftime('%s', 'now') AS INTEGER), "
        "bytes = length(CAST(text AS BLOB))");
  }
  // What is asked with every request must not walk through all scenes.
  database_->run("CREATE INDEX IF NOT EXISTS scenes_by_use ON scenes (used)");
  database_->run("CREATE INDEX IF NOT EXISTS scenes_by_client ON scenes (client, bytes)");
  database_->run(
      "CREATE TABLE IF NOT EXISTS owners (id TEXT NOT NULL, key_hash TEXT NOT NULL, "
      "PRIMARY KEY (id, key_hash)) WITHOUT ROWID");
  database_->run(
      "CREATE TRIGGER IF NOT EXISTS scenes_go AFTER DELETE ON scenes "
      "BEGIN DELETE FROM owners WHERE id = OLD.id; END");
}

// Only who is alone with the file can make it one that is shared. Where several try at once SQLite
// lets them wait for nobody, for they would wait for each other.
void SceneFile::share() {
  constexpr int pause_ms = 1;
  for (int waited_ms = 0;; waited_ms += pause_ms) try {
      if (database_->word("PRAGMA journal_mode = WAL") == "wal") return;
      reject("the folder's file system cannot share memory (SQLite's WAL)");
    } catch (const DatabaseError& error) {
      if (error.kind != DatabaseError::busy || waited_ms >= timeout_ms) throw;
      std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    }
}

void SceneFile::keep(const std::string& id, const std::string& text, const Owner& owner) try {
  const std::lock_guard lock(mutex_);
  check_share(id, text, owner);
  Database::Transaction all(*database_);
  Database::Statement insert(
      *database_,
      "INSERT INTO scenes (id, text, client, used, bytes) VALUES (?, ?, ?, ?, ?) "
      "ON CONFLICT (id) DO UPDATE SET used = max(used, excluded.used)");
  insert.bind(1, id);
  insert.bind(2, text);
  insert.bind(3, owner.client);
  insert.bind(4, owner.time_s);
  insert.bind(5, static_cast<std::int64_t>(text.size()));
  insert.next();
  if (!owner.key_hash.empty()) {
    Database::Statement own(*database_,
                            "INSERT OR IGNORE INTO owners (id, key_hash) SELECT ?1, ?2 "
                            "WHERE (SELECT count(*) FROM owners WHERE id = ?1) < ?3");
    own.bind(1, id);
    own.bind(2, owner.key_hash);
    own.bind(3, std::int64_t{most_owners});
    own.next();
  }
  all.commit();
  measure();
} catch (const DatabaseError& error) {
  refuse(error);
}

// Half of the file at most is one client's.
void SceneFile::check_share(const std::string& id, const std::string& text, const Owner& owner) {
  if (owner.client.empty()) return;
  Database::Statement known(*database_, "SELECT 1 FROM scenes WHERE id = ?");
  known.bind(1, id);
  if (known.next()) return;
  Database::Statement held(*database_,
                           "SELECT coalesce(sum(bytes), 0) FROM scenes WHERE client = ?");
  held.bind(1, owner.client);
  held.next();
  if (std::stoll(held.text()) + static_cast<std::int64_t>(text.size()) > max_bytes_ / 2)
    throw HttpError("storage-full",
                    "half of the file of kept scenes (option TIA_MAX_DATA_BYTES) is yours already: "
                    "delete some of yours");
}

void SceneFile::touch(const std::string& id, std::int64_t now_s) try {
  const std::lock_guard lock(mutex_);
  Database::Statement update(*database_, "UPDATE scenes SET used = ? WHERE id = ?");
  update.bind(1, now_s);
  update.bind(2, id);
  update.next();
} catch (const DatabaseError& error) {
  refuse(error);
}

Removal SceneFile::remove(const std::string& id, const std::string& key_hash) try {
  const std::lock_guard lock(mutex_);
  Database::Transaction all(*database_);
  const auto run_for = [&](const char* sql, bool with_key) {
    Database::Statement statement(*database_, sql);
    statement.bind(1, id);
    if (with_key) statement.bind(2, key_hash);
    statement.next();
    return database_->changes() > 0;
  };
  Database::Statement known(*database_, "SELECT 1 FROM scenes WHERE id = ?");
  known.bind(1, id);
  if (!known.next()) return Removal::unknown;
  if (!run_for("DELETE FROM owners WHERE id = ? AND key_hash = ?", true)) return Removal::forbidden;
  run_for("DELETE FROM scenes WHERE id = ?1 AND NOT EXISTS (SELECT 1 FROM owners WHERE id = ?1)",
          false);
  all.commit();
  measure();
  return Removal::done;
} catch (const DatabaseError& error) {
  refuse(error);
}

bool SceneFile::contains(const std::string& id) try {
  const std::lock_guard lock(mutex_);
  Database::Statement known(*database_, "SELECT 1 FROM scenes WHERE id = ?");
  known.bind(1, id);
  return known.next();
} catch (const DatabaseError& error) {
  refuse(error);
}

bool SceneFile::knows_owner(const std::string& id, const std::string& key_hash) try {
  const std::lock_guard lock(mutex_);
  Database::Statement known(*database_, "SELECT 1 FROM owners WHERE id = ? AND key_hash = ?");
  known.bind(1, id);
  known.bind(2, key_hash);
  return known.next();
} catch (const DatabaseError& error) {
  refuse(error);
}

void SceneFile::forget_unused_since(std::int64_t time_s) try {
  const std::lock_guard lock(mutex_);
  {
    Database::Statement old(*database_, "SELECT 1 FROM scenes WHERE used < ? LIMIT 1");
    old.bind(1, time_s);
    if (!old.next()) return;
  }
  Database::Transaction all(*database_);
  Database::Statement gone(*database_, "DELETE FROM scenes WHERE used < ?");
  gone.bind(1, time_s);
  gone.next();
  all.commit();
  measure();
} catch (const DatabaseError& error) {
  refuse(error);
}

std::optional<std::string> SceneFile::find(const std::string& id) try {
  const std::lock_guard lock(mutex_);
  Database::Statement select(*database_, "SELECT text FROM scenes WHERE id = ?");
  select.bind(1, id);
  if (!select.next()) return std::nullopt;
  std::string text = select.text();
  if (sha256_hex(text) != id) reject("a text that its id does not fit");
  return text;
} catch (const DatabaseError& error) {
  refuse(error);
}

// SQLite checks its own structure; here each text is checked against its id. Cost: for a
// gigabyte 1.4 s where scenes are large, 5.8 s where they have a kilobyte each, and the disk's
// time.
void SceneFile::look_through() {
  if (const std::string found = database_->word("PRAGMA integrity_check(1)"); found != "ok")
    reject("it is damaged: " + found);
  for (Database::Statement all(*database_, "SELECT id, text FROM scenes"); all.next();)
    if (all.text(0) != sha256_hex(all.text(1))) reject("it is damaged: the text of " + all.text(0));
}

void SceneFile::measure() {
  bytes_ = (std::stoll(database_->word("PRAGMA page_count")) -
            std::stoll(database_->word("PRAGMA freelist_count"))) *
           std::stoll(database_->word("PRAGMA page_size"));
}

}  // namespace tia::server
