// SQLite, which alone knows how to survive a crash, as three things: a database, its statements and
// its transactions. The only place that includes it.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace tia::server {

/// DatabaseError: what SQLite says went wrong; it is for the log.
struct DatabaseError : std::runtime_error {
  enum Kind { full, busy, other };
  DatabaseError(Kind is, const std::string& text) : std::runtime_error(text), kind(is) {}
  Kind kind;
};

/// Database: an open file. One thread at a time.
/// Errors, of all that follows: DatabaseError; std::bad_alloc.
class Database {
 public:
  class Statement;
  class Transaction;

  /// Opens the file, or begins it. Who finds it locked by another process waits so long.
  Database(const std::string& path, int timeout_ms);

  void run(const std::string& sql);
  /// The first column of the first row, or "".
  std::string word(const std::string& sql);
  /// How many rows the last statement has changed.
  int changes() const;

 private:
  [[noreturn]] void fail() const;

  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

/// Statement: one of SQL, run row by row.
class Database::Statement {
 public:
  Statement(Database& database, const std::string& sql);
  /// Puts a value in place of the question mark of that number, from 1. Domain: a text lives as
  /// long as the statement.
  void bind(int place, std::int64_t number);
  void bind(int place, const std::string& text);
  void bind_bytes(int place, const std::string& bytes);
  /// Returns: whether there is one more row.
  bool next();
  std::string text(int column = 0) const;
  std::int64_t number(int column = 0) const;
  std::string bytes(int column = 0) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const;
  };
  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

/// Transaction: all changes that are made while it lives, once they are committed; else none.
class Database::Transaction {
 public:
  explicit Transaction(Database& database) : database_(database) {
    database.run("BEGIN IMMEDIATE");
  }
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool is_open_ = true;
};

}  // namespace tia::server
