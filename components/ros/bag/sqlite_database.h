// The little of SQLite's C interface that bags need, with its errors as values.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "components/core/outcome.h"

namespace goalnet::ros {

// One thread.
class SqliteDatabase {
 public:
  // `flags` as for sqlite3_open_v2(). kInvalidRequest if it is no database or cannot be opened.
  static Expected<SqliteDatabase> open(const std::string& path, int flags);
  static Expected<SqliteDatabase> in_memory(std::span<const std::uint8_t> bytes);

  Expected<void> run(const std::string& sql);  // statements without results
  sqlite3* handle() const { return handle_.get(); }
  Error error(const std::string& doing) const;  // what SQLite said last

 private:
  struct Close {
    void operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }
  };
  std::unique_ptr<sqlite3, Close> handle_;
};

// Must not outlive its database.
class SqliteStatement {
 public:
  static Expected<SqliteStatement> prepare(const SqliteDatabase& database, const std::string& sql);

  void bind(int index, std::int64_t value) { sqlite3_bind_int64(statement_.get(), index, value); }
  void bind(int index, const std::string& value);
  void bind(int index, std::span<const std::uint8_t> value);  // must live until step()

  // True: a row is there; false: done.
  Expected<bool> step();
  void reset() { sqlite3_reset(statement_.get()); }
  // Columns of the current row.
  std::int64_t integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
  std::string text(int column) const;
  std::span<const std::uint8_t> blob(int column) const;

 private:
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
  };
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

}  // namespace goalnet::ros
