// Decodes every message of an MCAP file with software that is not ours: node read_mcap.mjs FILE
// Uses the indexed reader where the file has a summary, the streaming reader where it was cut off.
// Prints which one, then for each topic: name, number of messages, and the last message as JSON.
import { readFileSync } from "node:fs";
import { open } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import zstd from "@foxglove/wasm-zstd";

await zstd.isLoaded;
const decompressHandlers = { zstd: (bytes, size) => zstd.decompress(bytes, Number(size)) };
const file = process.argv[2];
const handle = await open(file, "r");
const size = BigInt((await handle.stat()).size);
const readable = {
  size: async () => size,
  read: async (offset, length) => {
    const buffer = new Uint8Array(Number(length));
    const { bytesRead } = await handle.read(buffer, 0, buffer.length, Number(offset));
    if (bytesRead !== buffer.length) throw new Error("short read");
    return buffer;
  },
};

const counts = new Map();
const last = new Map();
const readers = new Map();
function take(channel, schema, data) {
  if (schema.encoding !== "ros2msg" || channel.messageEncoding !== "cdr") throw new Error("unexpected encoding");
  if (!channel.metadata.get("offered_qos_profiles")?.startsWith("- history: ")) throw new Error("no QoS");
  if (!readers.has(channel.id)) {
    readers.set(channel.id, new MessageReader(parse(new TextDecoder().decode(schema.data), { ros2: true })));
  }
  const message = readers.get(channel.id).readMessage(data);
  counts.set(channel.topic, (counts.get(channel.topic) ?? 0) + 1);
  last.set(channel.topic, message);
}

let indexed;
try {
  indexed = await McapIndexedReader.Initialize({ readable, decompressHandlers });
} catch {
  indexed = undefined; // no summary: the recorder was killed
}
if (indexed) {
  console.log("indexed, chunks", indexed.chunkIndexes.length, "profile", indexed.header.profile);
  for await (const metadata of indexed.readMetadata({ name: "rosbag2" })) {
    const text = metadata.metadata.get("serialized_metadata");
    console.log("metadata", text ? text.match(/message_count: \d+/)[0] : metadata.metadata.get("ROS_DISTRO"));
  }
  let time = 0n;
  for await (const message of indexed.readMessages()) {
    if (message.logTime < time) throw new Error("out of order");
    time = message.logTime;
    const channel = indexed.channelsById.get(message.channelId);
    take(channel, indexed.schemasById.get(channel.schemaId), message.data);
  }
  for (const [id, count] of indexed.statistics.channelMessageCounts) {
    const topic = indexed.channelsById.get(id).topic;
    if (BigInt(counts.get(topic) ?? 0) !== count) throw new Error("statistics are wrong for " + topic);
  }
} else {
  console.log("stream");
  const stream = new McapStreamReader({ decompressHandlers });
  stream.append(readFileSync(file));
  const channels = new Map();
  const schemas = new Map();
  for (let record; (record = stream.nextRecord()); ) {
    if (record.type === "Schema") schemas.set(record.id, record);
    if (record.type === "Channel") channels.set(record.id, record);
    if (record.type === "Message") {
      const channel = channels.get(record.channelId);
      take(channel, schemas.get(channel.schemaId), record.data);
    }
  }
}
const json = (value) =>
  JSON.stringify(value, (_, one) =>
    typeof one === "bigint" ? Number(one) : ArrayBuffer.isView(one) ? Array.from(one) : one);
for (const [topic, count] of [...counts].sort()) console.log(topic, count, json(last.get(topic)));
await handle.close();
