#include "components/ros/bag/sqlite_database.h"

#include <algorithm>

namespace goalnet::ros {
namespace {

// Files of others may hold anything: no extensions, no side effects of reading, no values without bounds.
void guard(sqlite3* handle) {
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, 256 << 20);
  sqlite3_busy_timeout(handle, 1000);
}

}  // namespace

Expected<SqliteDatabase> SqliteDatabase::open(const std::string& path, int flags) {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(path.c_str(), &handle, flags, nullptr);
  SqliteDatabase database;
  database.handle_.reset(handle);
  if (code != SQLITE_OK) {
    return fail(
        Outcome::kInvalidRequest,
        "cannot open " + path + ": " + (handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code)));
  }
  guard(handle);
  return database;
}

Expected<SqliteDatabase> SqliteDatabase::in_memory(std::span<const std::uint8_t> bytes) {
  auto database = open(":memory:", SQLITE_OPEN_READWRITE);
  if (!database) return database;
  auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(std::max<std::size_t>(bytes.size(), 1)));
  if (copy == nullptr) return fail(Outcome::kInternal, "out of memory");
  std::copy(bytes.begin(), bytes.end(), copy);
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  // The database frees the copy, also where this fails.
  if (sqlite3_deserialize(database->handle(), "main", copy, size, size,
                          SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_READONLY) != SQLITE_OK) {
    return tl::unexpected(database->error("read a database in memory"));
  }
  return database;
}

Expected<void> SqliteDatabase::run(const std::string& sql) {
  if (sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    return tl::unexpected(error("write the recording"));
  }
  return {};
}

Error SqliteDatabase::error(const std::string& doing) const {
  return {Outcome::kInternal, "cannot " + doing + ": " + sqlite3_errmsg(handle_.get())};
}

Expected<SqliteStatement> SqliteStatement::prepare(const SqliteDatabase& database, const std::string& sql) {
  sqlite3_stmt* handle = nullptr;
  const int code =
      sqlite3_prepare_v2(database.handle(), sql.c_str(), static_cast<int>(sql.size()), &handle, nullptr);
  SqliteStatement statement;
  statement.statement_.reset(handle);
  if (code != SQLITE_OK) return fail(Outcome::kInvalidRequest, sqlite3_errmsg(database.handle()));
  return statement;
}

void SqliteStatement::bind(int index, const std::string& value) {
  sqlite3_bind_text64(statement_.get(), index, value.data(), value.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void SqliteStatement::bind(int index, std::span<const std::uint8_t> value) {
  sqlite3_bind_blob64(statement_.get(), index, value.data(), value.size(), SQLITE_STATIC);
}

Expected<bool> SqliteStatement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  return fail(Outcome::kInternal, sqlite3_errmsg(sqlite3_db_handle(statement_.get())));
}

std::string SqliteStatement::text(int column) const {
  const auto* start = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return start == nullptr ? "" : std::string(start, static_cast<std::size_t>(size));
}

std::span<const std::uint8_t> SqliteStatement::blob(int column) const {
  const auto* start = static_cast<const std::uint8_t*>(sqlite3_column_blob(statement_.get(), column));
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return start == nullptr ? std::span<const std::uint8_t>()
                          : std::span(start, static_cast<std::size_t>(size));
}

}  // namespace goalnet::ros
