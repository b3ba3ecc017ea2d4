// SQL with its values, and rows as plain data.
#pragma once

#include <string>

#include "server/jobs/job.h"
#include "server/stores/database.h"

namespace tia::server {

inline void bind_values(Database::Statement&, int) {}
template <class... More>
void bind_values(Database::Statement& to, int place, const std::string& text, const More&... more);
template <class... More>
void bind_values(Database::Statement& to, int place, std::int64_t number, const More&... more) {
  to.bind(place, number);
  bind_values(to, place + 1, more...);
}
template <class... More>
void bind_values(Database::Statement& to, int place, const std::string& text, const More&... more) {
  to.bind(place, text);
  bind_values(to, place + 1, more...);
}

/// A statement with values in the places of its question marks. Domain: they outlive it.
template <class... Values>
Database::Statement with_values(Database& database, const std::string& sql,
                                const Values&... values) {
  Database::Statement statement(database, sql);
  bind_values(statement, 1, values...);
  return statement;
}
/// Runs it.
template <class... Values>
void run_with(Database& database, const std::string& sql, const Values&... values) {
  auto statement = with_values(database, sql, values...);
  while (statement.next()) {
  }
}
/// The first number of its first row, or 0.
template <class... Values>
std::int64_t number_of(Database& database, const std::string& sql, const Values&... values) {
  auto statement = with_values(database, sql, values...);
  return statement.next() ? statement.number() : 0;
}

/// More than any part's number.
constexpr std::int64_t beyond_parts = 1 << 30;

/// The tables, as they are begun.
extern const char* const job_tables;
/// The columns of a job, in the order in which job_in reads them; and of a part.
extern const char* const job_columns;
extern const char* const part_columns;
Job job_in(const Database::Statement& row);
PartRow part_in(const Database::Statement& row);

}  // namespace tia::server
