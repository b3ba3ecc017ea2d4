#include "server/stores/scene_file.h"

#include <sqlite3.h>

#include <filesystem>
#include <new>
#include <stdexcept>

#include "server/contract/problem.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

constexpr int application_id = 0x54696100;  // "Tia", in the file's header, as file(1) shows it
constexpr int layout_version = 2;           // 1 knew no owners and no times
constexpr int timeout_ms = 5000;            // with another process that is writing

/// Failure: what SQLite says went wrong.
struct Failure : std::runtime_error {
  Failure(int given, const char* text) : std::runtime_error(text), code(given & 0xFF) {}
  int code;
};

// The file's text stays in the log: it is nobody else's business.
[[noreturn]] void refuse(const Failure& failure) {
  if (failure.code == SQLITE_NOMEM) throw std::bad_alloc();
  if (failure.code == SQLITE_FULL)
    throw HttpError("storage-full",
                    "the file of kept scenes is full (option TIA_MAX_DATA_BYTES), or the disk is");
  throw StorageError(std::string("the file of kept scenes: ") + failure.what());
}

}  // namespace

/// Statement: one SQL statement, run row by row.
class SceneFile::Statement {
 public:
  Statement(SceneFile& file, const std::string& sql) : file_(file) {
    sqlite3_stmt* made = nullptr;
    const int code = sqlite3_prepare_v2(file.database_.get(), sql.c_str(), -1, &made, nullptr);
    statement_.reset(made);
    if (code != SQLITE_OK) file.fail();
  }
  void bind(int place, std::int64_t number) {
    if (sqlite3_bind_int64(statement_.get(), place, number) != SQLITE_OK) file_.fail();
  }
  void bind(int place, const std::string& text) {
    if (sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(), SQLITE_STATIC,
                            SQLITE_UTF8) != SQLITE_OK)
      file_.fail();
  }
  /// Returns: whether there is one more row.
  bool next() {
    const int code = sqlite3_step(statement_.get());
    if (code != SQLITE_ROW && code != SQLITE_DONE) file_.fail();
    return code == SQLITE_ROW;
  }
  std::string text(int column = 0) {
    const auto* bytes = sqlite3_column_text(statement_.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
    return bytes == nullptr ? "" : std::string(reinterpret_cast<const char*>(bytes), size);
  }

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  SceneFile& file_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Transaction: all of its changes, or none.
class SceneFile::Transaction {
 public:
  explicit Transaction(SceneFile& file) : file_(file) { file_.run("BEGIN IMMEDIATE"); }
  ~Transaction() {
    if (is_open_) sqlite3_exec(file_.database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit() {
    file_.run("COMMIT");
    is_open_ = false;
  }

 private:
  SceneFile& file_;
  bool is_open_ = true;
};

void SceneFile::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

SceneFile::SceneFile(const std::string& folder, std::int64_t max_bytes) : max_bytes_(max_bytes) {
  const std::string path = folder + "/" + name;
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    throw std::runtime_error("option TIA_DATA_DIR: got " + folder +
                             ", allowed: a folder that is there and can be written to");
  try {
    open(path);
    prepare(max_bytes);
  } catch (const Failure& failure) {
    throw std::runtime_error("option TIA_DATA_DIR: " + path + ": " + failure.what());
  }
}

SceneFile::~SceneFile() = default;

void SceneFile::open(const std::string& path) {
  sqlite3* made = nullptr;
  constexpr int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int code = sqlite3_open_v2(path.c_str(), &made, flags, nullptr);
  database_.reset(made);
  if (made == nullptr) throw std::bad_alloc();
  if (code != SQLITE_OK) fail();
  sqlite3_extended_result_codes(made, 1);
  sqlite3_busy_timeout(made, timeout_ms);
}

// All that can be wrong with the file comes to light here: it is written to even if nothing is new.
void SceneFile::prepare(std::int64_t max_bytes) {
  run("BEGIN");  // else another process may begin the file between one answer and the next
  const std::string of = word("PRAGMA application_id"), is = word("PRAGMA user_version");
  const bool is_new = word("SELECT count(*) FROM sqlite_schema") == "0";
  run("COMMIT");
  if (!is_new && of != std::to_string(application_id))
    throw Failure(SQLITE_NOTADB, "this is another program's file");
  if (!is_new && is != std::to_string(layout_version) && is != "1")
    throw Failure(SQLITE_NOTADB, "another version of Tia has written this file");
  if (!is_new) look_through();
  share();
  run("PRAGMA synchronous = FULL");  // a commit is on the disk before it is told
  run("PRAGMA temp_store = MEMORY");
  run("PRAGMA journal_size_limit = 8388608");
  const std::int64_t pages = max_bytes / std::stoll(word("PRAGMA page_size"));
  run(("PRAGMA max_page_count = " + std::to_string(pages)).c_str());
  run("BEGIN IMMEDIATE");
  lay_out(word("PRAGMA user_version"));
  run(("PRAGMA application_id = " + std::to_string(application_id)).c_str());
  run(("PRAGMA user_version = " + std::to_string(layout_version)).c_str());
  run("COMMIT");
  measure();
}

// What version 1 has kept belongs to nobody: it can only fall out of use, from now on.
void SceneFile::lay_out(const std::string& version) {
  run("CREATE TABLE IF NOT EXISTS scenes (id TEXT PRIMARY KEY NOT NULL, text TEXT NOT NULL, "
      "client TEXT NOT NULL DEFAULT '', used INTEGER NOT NULL DEFAULT 0, "
      "bytes INTEGER NOT NULL DEFAULT 0)");
  if (version == "1") {
    run("ALTER TABLE scenes ADD COLUMN client TEXT NOT NULL DEFAULT ''");
    run("ALTER TABLE scenes ADD COLUMN used INTEGER NOT NULL DEFAULT 0");
    run("ALTER TABLE scenes ADD COLUMN bytes INTEGER NOT NULL DEFAULT 0");
    run("UPDATE scenes SET used = CAST(strftime('%s', 'now') AS INTEGER), "
        "bytes = length(CAST(text AS BLOB))");
  }
  // What is asked with every request must not walk through all scenes.
  run("CREATE INDEX IF NOT EXISTS scenes_by_use ON scenes (used)");
  run("CREATE INDEX IF NOT EXISTS scenes_by_client ON scenes (client, bytes)");
  run("CREATE TABLE IF NOT EXISTS owners (id TEXT NOT NULL, key_hash TEXT NOT NULL, "
      "PRIMARY KEY (id, key_hash)) WITHOUT ROWID");
  run("CREATE TRIGGER IF NOT EXISTS scenes_go AFTER DELETE ON scenes "
      "BEGIN DELETE FROM owners WHERE id = OLD.id; END");
}

// Only who is alone with the file can make it one that is shared. Where several try at once SQLite
// lets them wait for nobody, for they would wait for each other.
void SceneFile::share() {
  constexpr int pause_ms = 1;
  for (int waited_ms = 0;; waited_ms += pause_ms) try {
      if (word("PRAGMA journal_mode = WAL") == "wal") return;
      throw Failure(SQLITE_CANTOPEN, "the folder's file system cannot share memory (SQLite's WAL)");
    } catch (const Failure& failure) {
      if (failure.code != SQLITE_BUSY || waited_ms >= timeout_ms) throw;
      sqlite3_sleep(pause_ms);
    }
}

void SceneFile::keep(const std::string& id, const std::string& text, const Owner& owner) try {
  const std::lock_guard lock(mutex_);
  check_share(id, text, owner);
  Transaction all(*this);
  Statement insert(*this,
                   "INSERT INTO scenes (id, text, client, used, bytes) VALUES (?, ?, ?, ?, ?) "
                   "ON CONFLICT (id) DO UPDATE SET used = max(used, excluded.used)");
  insert.bind(1, id);
  insert.bind(2, text);
  insert.bind(3, owner.client);
  insert.bind(4, owner.time_s);
  insert.bind(5, static_cast<std::int64_t>(text.size()));
  insert.next();
  if (!owner.key_hash.empty()) {
    Statement own(*this,
                  "INSERT OR IGNORE INTO owners (id, key_hash) SELECT ?1, ?2 "
                  "WHERE (SELECT count(*) FROM owners WHERE id = ?1) < ?3");
    own.bind(1, id);
    own.bind(2, owner.key_hash);
    own.bind(3, std::int64_t{most_owners});
    own.next();
  }
  all.commit();
  measure();
} catch (const Failure& failure) {
  refuse(failure);
}

// Half of the file at most is one client's.
void SceneFile::check_share(const std::string& id, const std::string& text, const Owner& owner) {
  if (owner.client.empty()) return;
  Statement known(*this, "SELECT 1 FROM scenes WHERE id = ?");
  known.bind(1, id);
  if (known.next()) return;
  Statement held(*this, "SELECT coalesce(sum(bytes), 0) FROM scenes WHERE client = ?");
  held.bind(1, owner.client);
  held.next();
  if (std::stoll(held.text()) + static_cast<std::int64_t>(text.size()) > max_bytes_ / 2)
    throw HttpError("storage-full",
                    "half of the file of kept scenes (option TIA_MAX_DATA_BYTES) is yours already: "
                    "delete some of yours");
}

void SceneFile::touch(const std::string& id, std::int64_t now_s) try {
  const std::lock_guard lock(mutex_);
  Statement update(*this, "UPDATE scenes SET used = ? WHERE id = ?");
  update.bind(1, now_s);
  update.bind(2, id);
  update.next();
} catch (const Failure& failure) {
  refuse(failure);
}

Removal SceneFile::remove(const std::string& id, const std::string& key_hash) try {
  const std::lock_guard lock(mutex_);
  Transaction all(*this);
  const auto run_for = [&](const char* sql, bool with_key) {
    Statement statement(*this, sql);
    statement.bind(1, id);
    if (with_key) statement.bind(2, key_hash);
    statement.next();
    return sqlite3_changes(database_.get()) > 0;
  };
  Statement known(*this, "SELECT 1 FROM scenes WHERE id = ?");
  known.bind(1, id);
  if (!known.next()) return Removal::unknown;
  if (!run_for("DELETE FROM owners WHERE id = ? AND key_hash = ?", true)) return Removal::forbidden;
  run_for("DELETE FROM scenes WHERE id = ?1 AND NOT EXISTS (SELECT 1 FROM owners WHERE id = ?1)",
          false);
  all.commit();
  measure();
  return Removal::done;
} catch (const Failure& failure) {
  refuse(failure);
}

bool SceneFile::contains(const std::string& id) try {
  const std::lock_guard lock(mutex_);
  Statement known(*this, "SELECT 1 FROM scenes WHERE id = ?");
  known.bind(1, id);
  return known.next();
} catch (const Failure& failure) {
  refuse(failure);
}

bool SceneFile::knows_owner(const std::string& id, const std::string& key_hash) try {
  const std::lock_guard lock(mutex_);
  Statement known(*this, "SELECT 1 FROM owners WHERE id = ? AND key_hash = ?");
  known.bind(1, id);
  known.bind(2, key_hash);
  return known.next();
} catch (const Failure& failure) {
  refuse(failure);
}

void SceneFile::forget_unused_since(std::int64_t time_s) try {
  const std::lock_guard lock(mutex_);
  {
    Statement old(*this, "SELECT 1 FROM scenes WHERE used < ? LIMIT 1");
    old.bind(1, time_s);
    if (!old.next()) return;
  }
  Transaction all(*this);
  Statement gone(*this, "DELETE FROM scenes WHERE used < ?");
  gone.bind(1, time_s);
  gone.next();
  all.commit();
  measure();
} catch (const Failure& failure) {
  refuse(failure);
}

std::optional<std::string> SceneFile::find(const std::string& id) try {
  const std::lock_guard lock(mutex_);
  Statement select(*this, "SELECT text FROM scenes WHERE id = ?");
  select.bind(1, id);
  if (!select.next()) return std::nullopt;
  std::string text = select.text();
  if (sha256_hex(text) != id) throw Failure(SQLITE_CORRUPT, "a text that its id does not fit");
  return text;
} catch (const Failure& failure) {
  refuse(failure);
}

// SQLite sees to its own order, we to the texts. Cost: for a gigabyte 1.4 s where scenes are
// large, 5.8 s where they have a kilobyte each, and the disk's time.
void SceneFile::look_through() {
  if (const std::string found = word("PRAGMA integrity_check(1)"); found != "ok")
    throw Failure(SQLITE_CORRUPT, ("it is damaged: " + found).c_str());
  for (Statement all(*this, "SELECT id, text FROM scenes"); all.next();)
    if (all.text(0) != sha256_hex(all.text(1)))
      throw Failure(SQLITE_CORRUPT, ("it is damaged: the text of " + all.text(0)).c_str());
}

void SceneFile::measure() {
  bytes_ = (std::stoll(word("PRAGMA page_count")) - std::stoll(word("PRAGMA freelist_count"))) *
           std::stoll(word("PRAGMA page_size"));
}

void SceneFile::run(const char* sql) {
  Statement statement(*this, sql);
  while (statement.next()) {
  }
}

// The first column of the first row.
std::string SceneFile::word(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.next() ? statement.text() : "";
}

void SceneFile::fail() const {
  throw Failure(sqlite3_extended_errcode(database_.get()), sqlite3_errmsg(database_.get()));
}

}  // namespace tia::server
