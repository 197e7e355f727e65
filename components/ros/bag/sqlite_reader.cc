#include <sys/stat.h>

#include <map>

#include "components/ros/bag/offered_qos.h"
#include "components/ros/bag/sqlite_database.h"
#include "components/ros/bag/storage_reader.h"

namespace goalnet::ros {
namespace {

constexpr std::size_t kMostTopics = 100'000;

class SqliteReader : public StorageReader {
 public:
  SqliteReader(SqliteDatabase database, std::string name, bool finished)
      : database_(std::move(database)), name_(std::move(name)), finished_(finished) {}

  Expected<void> open();
  const std::vector<BagTopic>& topics() const override { return topics_; }
  bool finished() const override { return finished_; }
  Expected<bool> next(BagMessage& message) override;

 private:
  Error broken(const std::string& why) const { return {Outcome::kInvalidRequest, name_ + ": " + why}; }
  Expected<bool> has(const std::string& table, const std::string& column) const;
  Expected<SqliteStatement> prepare(const std::string& sql) const;
  Expected<void> read_topics();

  SqliteDatabase database_;
  const std::string name_;
  const bool finished_;
  std::vector<BagTopic> topics_;
  std::map<std::int64_t, std::size_t> topic_of_id_;
  std::unique_ptr<SqliteStatement> messages_;  // last: goes before its database
};

Expected<SqliteStatement> SqliteReader::prepare(const std::string& sql) const {
  auto statement = SqliteStatement::prepare(database_, sql);
  if (!statement) return tl::unexpected(broken("it is no bag: " + statement.error().message));
  return statement;
}

// Only real tables count: a view could compute for ever.
Expected<bool> SqliteReader::has(const std::string& table, const std::string& column) const {
  auto statement = prepare(
      "SELECT count(*) FROM sqlite_master AS m, pragma_table_info(m.name) AS c WHERE m.type='table' AND "
      "m.name=? AND "
      "c.name=?");
  if (!statement) return tl::unexpected(statement.error());
  statement->bind(1, table);
  statement->bind(2, column);
  auto row = statement->step();
  if (!row) return tl::unexpected(broken(row.error().message));
  return *row && statement->integer(0) > 0;
}

Expected<void> SqliteReader::open() {
  for (const auto& [table, column] :
       {std::pair("topics", "serialization_format"), std::pair("messages", "data")}) {
    auto there = has(table, column);
    if (!there) return tl::unexpected(there.error());
    if (!*there) return tl::unexpected(broken(std::string("it is no bag: it has no table ") + table));
  }
  if (auto read = read_topics(); !read) return read;
  auto statement = prepare("SELECT topic_id,timestamp,data FROM messages ORDER BY timestamp,id");
  if (!statement) return tl::unexpected(statement.error());
  messages_ = std::make_unique<SqliteStatement>(std::move(*statement));
  return {};
}

Expected<void> SqliteReader::read_topics() {
  const auto has_qos = has("topics", "offered_qos_profiles"),
             has_hash = has("topics", "type_description_hash");
  const auto has_definitions = has("message_definitions", "encoded_message_definition");
  if (!has_qos || !has_hash || !has_definitions) return tl::unexpected(broken("its tables cannot be read"));
  std::map<std::string, std::string> definitions;
  if (*has_definitions) {
    auto statement = prepare(
        "SELECT topic_type,encoded_message_definition FROM message_definitions WHERE encoding='ros2msg'");
    if (!statement) return tl::unexpected(statement.error());
    auto row = statement->step();
    for (; row && *row && definitions.size() < kMostTopics; row = statement->step())
      definitions[statement->text(0)] = statement->text(1);
    if (!row) return tl::unexpected(broken(row.error().message));
  }
  auto statement = prepare(std::string("SELECT id,name,type,serialization_format,") +
                           (*has_qos ? "offered_qos_profiles," : "'',") +
                           (*has_hash ? "type_description_hash" : "''") + " FROM topics ORDER BY id");
  if (!statement) return tl::unexpected(statement.error());
  auto row = statement->step();
  for (; row && *row && topics_.size() < kMostTopics; row = statement->step()) {
    BagTopic topic;
    topic.name = statement->text(1);
    topic.type = statement->text(2);
    topic.serialization_format = statement->text(3);
    auto offered = parse_offered_qos(statement->text(4));
    if (!offered) return tl::unexpected(broken(topic.name.substr(0, 80) + ": " + offered.error().message));
    topic.offered = std::move(*offered);
    topic.type_hash = statement->text(5);
    if (const auto known = definitions.find(topic.type); known != definitions.end())
      topic.definition = known->second;
    topic_of_id_[statement->integer(0)] = topics_.size();
    topics_.push_back(std::move(topic));
  }
  if (!row) return tl::unexpected(broken(row.error().message));
  return {};
}

Expected<bool> SqliteReader::next(BagMessage& message) {
  auto row = messages_->step();
  if (!row) return tl::unexpected(broken(row.error().message));
  if (!*row) return false;
  const auto topic = topic_of_id_.find(messages_->integer(0));
  if (topic == topic_of_id_.end()) return tl::unexpected(broken("a message of no known topic"));
  message.topic = topic->second;
  message.log_time = message.publish_time =
      static_cast<std::uint64_t>(std::max<std::int64_t>(messages_->integer(1), 0));
  const auto data = messages_->blob(2);
  message.payload.assign(data.begin(), data.end());
  return true;
}

Expected<std::unique_ptr<StorageReader>> make(Expected<SqliteDatabase> database, const std::string& name,
                                              bool finished) {
  if (!database) return tl::unexpected<Error>(std::move(database.error()));
  auto reader = std::make_unique<SqliteReader>(std::move(*database), name, finished);
  if (auto ok = reader->open(); !ok) return tl::unexpected<Error>(std::move(ok.error()));
  return std::unique_ptr<StorageReader>(std::move(reader));
}

}  // namespace

Expected<std::unique_ptr<StorageReader>> open_sqlite(const std::string& path) {
  // A write-ahead log beside it means that its recorder was killed, or still runs.
  struct stat status {};
  const bool finished = ::stat((path + "-wal").c_str(), &status) != 0;
  auto database = SqliteDatabase::open(path, SQLITE_OPEN_READONLY);
  return make(std::move(database), path, finished);
}

Expected<std::unique_ptr<StorageReader>> open_sqlite_in_memory(std::vector<std::uint8_t> bytes) {
  return make(SqliteDatabase::in_memory(bytes), "the database", true);
}

}  // namespace goalnet::ros
