// Decodes every message of a .db3 file with software that is not ours: node read_sqlite.mjs FILE
// @foxglove/rosbag2 decodes the types it knows by itself; the others are decoded with the definitions in the file,
// where it has any (Jazzy). Prints for each topic: name, number of messages, and the last message as JSON.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import rosbag2 from "@foxglove/rosbag2";
import { SqliteSqljs } from "@foxglove/rosbag2-web";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";

// Its database engine would fetch itself over the network.
const wasmBinary = readFileSync(createRequire(import.meta.url).resolve("@foxglove/sql.js/dist/sql-wasm.wasm"));
const SQL = await SqliteSqljs.Initialize({ wasmBinary });
const bytes = new Uint8Array(readFileSync(process.argv[2]));
const counts = new Map();
const last = new Map();
function take(topic, message) {
  counts.set(topic, (counts.get(topic) ?? 0) + 1);
  last.set(topic, message);
}

const bag = new rosbag2.Rosbag2([new SqliteSqljs(bytes)]);
await bag.open();
const topics = await bag.readTopics();
for (const topic of topics) {
  if (topic.serializationFormat !== "cdr" || !topic.offeredQosProfiles.length) throw new Error("unexpected topic");
}
// Its Marker is that of Galactic, which has no textures.
const known = topics
  .filter((topic) => rosbag2.ROS2_TO_DEFINITIONS.has(topic.type) && !topic.type.startsWith("visualization_msgs/"))
  .map((topic) => topic.name);
const toOthers = new Set(topics.map((topic) => topic.name).filter((name) => !known.includes(name)));
let time = 0n;
for await (const message of bag.readMessages({ topics: known })) {
  const now = BigInt(message.timestamp.sec) * 1000000000n + BigInt(message.timestamp.nsec);
  if (now < time) throw new Error("out of order");
  time = now;
  take(message.topic.name, message.value);
}
await bag.close();

const database = new SQL.Database({ data: bytes });
const readers = new Map();
if (database.exec("select 1 from sqlite_master where name='message_definitions'").length) {
  for (const [type, encoding, text] of database.exec(
    "select topic_type, encoding, encoded_message_definition from message_definitions")[0].values) {
    if (encoding !== "ros2msg") throw new Error("unexpected encoding");
    readers.set(type, new MessageReader(parse(text, { ros2: true })));
  }
  const statement = database.prepare(
    "select t.name, t.type, m.data from messages m join topics t on t.id = m.topic_id order by m.timestamp, m.id");
  while (statement.step()) {
    const [topic, type, data] = statement.get();
    const message = readers.get(type).readMessage(data);
    if (toOthers.has(topic)) take(topic, message);
  }
  statement.free();
}
console.log("topics decoded by", "@foxglove/rosbag2", known.length, "definitions in the file", readers.size);
const json = (value) =>
  JSON.stringify(value, (_, one) =>
    typeof one === "bigint" ? Number(one) : ArrayBuffer.isView(one) ? Array.from(one) : one);
for (const [topic, count] of [...counts].sort()) console.log(topic, count, json(last.get(topic)));
