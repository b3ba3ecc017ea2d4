#include "server/stores/database.h"

#include <sqlite3.h>

#include <new>

namespace tia::server {

Database::Database(const std::string& path, int timeout_ms) {
  sqlite3* made = nullptr;
  constexpr int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int code = sqlite3_open_v2(path.c_str(), &made, flags, nullptr);
  database_.reset(made);
  if (made == nullptr) throw std::bad_alloc();
  if (code != SQLITE_OK) fail();
  sqlite3_extended_result_codes(made, 1);
  sqlite3_busy_timeout(made, timeout_ms);
}

void Database::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

void Database::run(const std::string& sql) {
  Statement statement(*this, sql);
  while (statement.next()) {
  }
}

std::string Database::word(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.next() ? statement.text() : "";
}

int Database::changes() const { return sqlite3_changes(database_.get()); }

void Database::fail() const {
  const int code = sqlite3_errcode(database_.get()) & 0xFF;  // without its extension
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  throw DatabaseError(code == SQLITE_FULL   ? DatabaseError::full
                      : code == SQLITE_BUSY ? DatabaseError::busy
                                            : DatabaseError::other,
                      sqlite3_errmsg(database_.get()));
}

// ---- statements -----------------------------------------------------------------------------

Database::Statement::Statement(Database& database, const std::string& sql) : database_(database) {
  sqlite3_stmt* made = nullptr;
  const int code = sqlite3_prepare_v2(database.database_.get(), sql.c_str(), -1, &made, nullptr);
  statement_.reset(made);
  if (code != SQLITE_OK) database.fail();
}

void Database::Statement::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

void Database::Statement::bind(int place, std::int64_t number) {
  if (sqlite3_bind_int64(statement_.get(), place, number) != SQLITE_OK) database_.fail();
}

void Database::Statement::bind(int place, const std::string& text) {
  if (sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(), SQLITE_STATIC,
                          SQLITE_UTF8) != SQLITE_OK)
    database_.fail();
}

void Database::Statement::bind_bytes(int place, const std::string& bytes) {
  if (sqlite3_bind_blob64(statement_.get(), place, bytes.data(), bytes.size(), SQLITE_STATIC) !=
      SQLITE_OK)
    database_.fail();
}

bool Database::Statement::next() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail();
  return code == SQLITE_ROW;
}

std::string Database::Statement::text(int column) const {
  const auto* bytes = sqlite3_column_text(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return bytes == nullptr ? "" : std::string(reinterpret_cast<const char*>(bytes), size);
}

std::int64_t Database::Statement::number(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

std::string Database::Statement::bytes(int column) const {
  const void* bytes = sqlite3_column_blob(statement_.get(), column);
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  return bytes == nullptr ? "" : std::string(static_cast<const char*>(bytes), size);
}

// ---- transactions ---------------------------------------------------------------------------

Database::Transaction::~Transaction() {
  if (is_open_) sqlite3_exec(database_.database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Database::Transaction::commit() {
  database_.run("COMMIT");
  is_open_ = false;
}

}  // namespace tia::server
