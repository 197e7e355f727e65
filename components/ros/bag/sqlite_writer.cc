// SQLite: the tables of `ros2 bag record --storage sqlite3`. One transaction from flush to flush. While
// recording a write-ahead log keeps what was committed safe from a crash; at the end it is folded into the
// one file.
#include <set>

#include "components/ros/bag/offered_qos.h"
#include "components/ros/bag/sqlite_database.h"
#include "components/ros/bag/storage_writer.h"

namespace goalnet::ros {
namespace {

// Texts as rosbag2 has them in the file: Humble's schema version is 3, Jazzy's 4.
constexpr const char* kSchema =
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY,ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY,metadata_version INTEGER NOT NULL,metadata TEXT NOT NULL);";
constexpr const char* kTopicsHumble =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format "
    "TEXT NOT "
    "NULL,offered_qos_profiles TEXT NOT NULL);"
    "INSERT INTO schema VALUES(3,'humble');";
constexpr const char* kTopicsJazzy =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT NOT NULL,type TEXT NOT NULL,serialization_format "
    "TEXT NOT "
    "NULL,offered_qos_profiles TEXT NOT NULL,type_description_hash TEXT NOT NULL);"
    "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY,topic_type TEXT NOT NULL,encoding TEXT NOT "
    "NULL,encoded_message_definition TEXT NOT NULL,type_description_hash TEXT NOT NULL);"
    "INSERT INTO schema VALUES(4,'jazzy');";
constexpr const char* kMessages =
    "CREATE TABLE messages(id INTEGER PRIMARY KEY,topic_id INTEGER NOT NULL,timestamp INTEGER NOT NULL, data "
    "BLOB NOT "
    "NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";

class SqliteWriter : public StorageWriter {
 public:
  SqliteWriter(SqliteDatabase database, const StorageOptions& options)
      : database_(std::move(database)), options_(options) {}

  Expected<void> begin(const BagMetadata& metadata);
  Expected<void> add_topic(const BagTopic& topic) override;
  Expected<void> write(std::size_t topic, std::uint64_t log_time, std::uint64_t publish_time,
                       std::span<const std::uint8_t> payload) override;
  Expected<void> flush() override;
  Expected<void> finish(BagMetadata& metadata) override;
  std::uint64_t size() const override { return size_; }

 private:
  bool jazzy() const { return options_.distro == Distro::kJazzy; }
  Expected<void> put_metadata(const BagMetadata& metadata);
  Expected<void> insert(const std::string& table, const std::vector<std::string>& texts);

  SqliteDatabase database_;
  const StorageOptions options_;
  std::unique_ptr<SqliteStatement> insert_message_;
  std::set<std::string> defined_;
  std::uint64_t size_ = 32 * 1024;  // [bytes] the empty tables
};

Expected<void> SqliteWriter::begin(const BagMetadata& metadata) {
  auto done = database_.run(std::string("PRAGMA journal_mode=WAL;PRAGMA synchronous=NORMAL;BEGIN;") +
                            kSchema + (jazzy() ? kTopicsJazzy : kTopicsHumble) + kMessages);
  if (!done) return done;
  auto statement =
      SqliteStatement::prepare(database_, "INSERT INTO messages(topic_id,timestamp,data) VALUES(?,?,?)");
  if (!statement) return tl::unexpected<Error>(std::move(statement.error()));
  insert_message_ = std::make_unique<SqliteStatement>(std::move(*statement));
  if (auto put = put_metadata(metadata); !put) return put;
  return flush();
}

Expected<void> SqliteWriter::put_metadata(const BagMetadata& metadata) {
  if (!jazzy()) return {};  // Humble leaves the table empty
  return insert("metadata(metadata_version,metadata)",
                {"9", embedded_metadata_yaml(metadata, options_.distro)});
}

Expected<void> SqliteWriter::insert(const std::string& table, const std::vector<std::string>& texts) {
  std::string places = "?";
  for (std::size_t i = 1; i < texts.size(); ++i) places += ",?";
  auto statement = SqliteStatement::prepare(database_, "INSERT INTO " + table + " VALUES(" + places + ")");
  if (!statement) return tl::unexpected<Error>(std::move(statement.error()));
  for (std::size_t i = 0; i < texts.size(); ++i) statement->bind(static_cast<int>(i) + 1, texts[i]);
  if (auto stepped = statement->step(); !stepped)
    return tl::unexpected(database_.error("write the recording"));
  for (const std::string& text : texts) size_ += text.size();
  return {};
}

Expected<void> SqliteWriter::add_topic(const BagTopic& topic) {
  const std::string qos = topic.offered.empty() ? "" : offered_qos_yaml(topic.offered, options_.distro);
  const std::vector<std::string> about{topic.name, topic.type, topic.serialization_format, qos};
  if (!jazzy()) return insert("topics(name,type,serialization_format,offered_qos_profiles)", about);
  if (defined_.insert(topic.type).second) {
    auto done = insert(
        "message_definitions(topic_type,encoding,encoded_message_definition,type_description_hash)",
        {topic.type, topic.definition.empty() ? "unknown" : "ros2msg", topic.definition, topic.type_hash});
    if (!done) return done;
  }
  return insert("topics(name,type,serialization_format,offered_qos_profiles,type_description_hash)",
                {about[0], about[1], about[2], about[3], topic.type_hash});
}

Expected<void> SqliteWriter::write(std::size_t topic, std::uint64_t log_time, std::uint64_t,
                                   std::span<const std::uint8_t> payload) {
  insert_message_->bind(1, static_cast<std::int64_t>(topic) + 1);
  insert_message_->bind(2, static_cast<std::int64_t>(log_time));
  insert_message_->bind(3, payload);
  auto stepped = insert_message_->step();
  insert_message_->reset();
  if (!stepped) return tl::unexpected(database_.error("write the recording"));
  size_ += payload.size() + 32;  // the row and its entry in the index
  return {};
}

Expected<void> SqliteWriter::flush() { return database_.run("COMMIT;BEGIN;"); }

Expected<void> SqliteWriter::finish(BagMetadata& metadata) {
  if (auto put = put_metadata(metadata); !put) return put;
  insert_message_.reset();
  // Leaving the write-ahead mode moves its content into the file and removes the two files beside it.
  return database_.run("COMMIT;PRAGMA journal_mode=DELETE;");
}

}  // namespace

Expected<std::unique_ptr<StorageWriter>> create_sqlite_writer(const std::string& path,
                                                              const BagMetadata& metadata,
                                                              const StorageOptions& options) {
  auto database = SqliteDatabase::open(path, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  if (!database) return tl::unexpected<Error>(std::move(database.error()));
  auto writer = std::make_unique<SqliteWriter>(std::move(*database), options);
  if (auto ok = writer->begin(metadata); !ok) return tl::unexpected<Error>(std::move(ok.error()));
  return std::unique_ptr<StorageWriter>(std::move(writer));
}

}  // namespace goalnet::ros
