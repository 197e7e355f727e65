/* A peer that shares no code with goalnet but the interface definitions: Cyclone DDS, with types made by idlc.
 *   cyclone_peer read DOMAIN SECONDS      prints what it receives on /world_state, /joint_states and /rosout
 *   cyclone_peer write DOMAIN SECONDS     publishes std_msgs/String on /instruction, ten times a second
 *   cyclone_peer latch DOMAIN SECONDS     publishes one std_msgs/String of 300,000 characters, latched, on /robot_description
 *   cyclone_peer churn DOMAIN SECONDS     readers and writers on our topics, silent, then a clean exit
 *   cyclone_peer undo DOMAIN SECONDS      a reader on /joint_states that goes after a second, while the peer stays
 */
#define _GNU_SOURCE
#include <dds/dds.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cyclone_topic.h"
#include "goalnet_msgs.h"
#include "rcl_interfaces.h"
#include "sensor_msgs.h"
#include "std_msgs.h"

static dds_qos_t* qos(int reliable, int transient_local, int depth) {
  dds_qos_t* made = dds_create_qos();
  dds_qset_reliability(made, reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT, DDS_SECS(1));
  dds_qset_durability(made, transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(made, DDS_HISTORY_KEEP_LAST, depth);
  return made;
}

static dds_entity_t reader(dds_entity_t participant, dds_entity_t on, int reliable, int transient_local, int depth) {
  dds_qos_t* q = qos(reliable, transient_local, depth);
  const dds_entity_t made = dds_create_reader(participant, on, q, NULL);
  check(made, "reader");
  dds_delete_qos(q);
  return made;
}

static dds_entity_t writer(dds_entity_t participant, dds_entity_t on, int transient_local, int depth) {
  dds_qos_t* q = qos(1, transient_local, depth);
  if (transient_local) { /* as rmw_cyclonedds does: this bounds what latecomers get */
    const int32_t any = DDS_LENGTH_UNLIMITED;
    dds_qset_durability_service(q, 0, DDS_HISTORY_KEEP_LAST, depth, any, any, any);
  }
  const dds_entity_t made = dds_create_writer(participant, on, q, NULL);
  check(made, "writer");
  dds_delete_qos(q);
  return made;
}

static void print_world(const goalnet_msgs_msg_WorldState* m) {
  printf("world_state %d.%09u %s objects", m->header.stamp.sec, m->header.stamp.nanosec, m->header.frame_id);
  for (uint32_t i = 0; i < m->objects._length; ++i) printf(" %s", m->objects._buffer[i]);
  printf(" facts");
  for (uint32_t i = 0; i < m->facts._length; ++i) {
    const goalnet_msgs_msg_Predicate* fact = &m->facts._buffer[i];
    printf(" (%s %s%s%s)", fact->relation, fact->subject, fact->object[0] != '\0' ? " " : "", fact->object);
  }
  printf("\n");
}

static void print_joints(const sensor_msgs_msg_JointState* m) {
  printf("joint_states %d.%09u", m->header.stamp.sec, m->header.stamp.nanosec);
  for (uint32_t i = 0; i < m->name._length; ++i) {
    printf(" %s=%.6f", m->name._buffer[i], i < m->position._length ? m->position._buffer[i] : 0.0);
  }
  printf("\n");
}

static void print_log(const rcl_interfaces_msg_Log* m) {
  printf("rosout %u %s: %s\n", (unsigned)m->level, m->name, m->msg);
}

/* Takes and prints everything that waits. */
#define DRAIN(reader_, Type, print)                                                                      \
  do {                                                                                                   \
    void* samples_[1] = {NULL};                                                                          \
    dds_sample_info_t info_;                                                                             \
    while (dds_take(reader_, samples_, &info_, 1, 1) > 0) {                                              \
      if (info_.valid_data) print((const Type*)samples_[0]);                                             \
      dds_return_loan(reader_, samples_, 1);                                                             \
      samples_[0] = NULL;                                                                                \
    }                                                                                                    \
  } while (0)

static void read_all(dds_entity_t p, dds_time_t end) {
  const dds_entity_t world = reader(
      p, topic(p, &goalnet_msgs_msg_WorldState_desc, "goalnet_msgs::msg::dds_::WorldState_", "rt/world_state"), 1, 1, 1);
  const dds_entity_t joints = reader(
      p, topic(p, &sensor_msgs_msg_JointState_desc, "sensor_msgs::msg::dds_::JointState_", "rt/joint_states"), 0, 0, 5);
  const dds_entity_t log =
      reader(p, topic(p, &rcl_interfaces_msg_Log_desc, "rcl_interfaces::msg::dds_::Log_", "rt/rosout"), 1, 1, 100);
  printf("ready\n");
  while (dds_time() < end) {
    DRAIN(world, goalnet_msgs_msg_WorldState, print_world);
    DRAIN(joints, sensor_msgs_msg_JointState, print_joints);
    DRAIN(log, rcl_interfaces_msg_Log, print_log);
    fflush(stdout);
    dds_sleepfor(DDS_MSECS(5));
  }
}

static void write_all(dds_entity_t p, dds_time_t end) {
  const dds_entity_t out =
      writer(p, topic(p, &std_msgs_msg_String_desc, "std_msgs::msg::dds_::String_", "rt/instruction"), 0, 10);
  for (int i = 0; dds_time() < end; ++i) {
    char text[64];
    snprintf(text, sizeof text, "fill mug %d with water", i);
    const std_msgs_msg_String message = {.data = text};
    check(dds_write(out, &message), "write");
    dds_sleepfor(DDS_MSECS(100));
  }
}

static void latch(dds_entity_t p, dds_time_t end) {
  const dds_entity_t out =
      writer(p, topic(p, &std_msgs_msg_String_desc, "std_msgs::msg::dds_::String_", "rt/robot_description"), 1, 1);
  static char text[300001];
  for (int i = 0; i < 300000; ++i) text[i] = (char)('a' + i % 26);
  const std_msgs_msg_String message = {.data = text};
  check(dds_write(out, &message), "write");
  printf("ready\n");
  fflush(stdout);
  while (dds_time() < end) dds_sleepfor(DDS_MSECS(20));
}

static void churn(dds_entity_t p, dds_time_t end) {
  const dds_time_t start = dds_time();
  static const char* const kTopics[] = {"rt/instruction", "rt/instruction_status_text", "rt/executor_command"};
  dds_entity_t out[3];
  for (int i = 0; i < 3; ++i) {
    const dds_entity_t on = topic(p, &std_msgs_msg_String_desc, "std_msgs::msg::dds_::String_", kTopics[i]);
    reader(p, on, 1, 0, 10);
    out[i] = writer(p, on, 0, 10);
  }
  reader(p, topic(p, &goalnet_msgs_msg_WorldState_desc, "goalnet_msgs::msg::dds_::WorldState_", "rt/world_state"), 1, 1, 1);
  reader(p, topic(p, &rcl_interfaces_msg_Log_desc, "rcl_interfaces::msg::dds_::Log_", "rt/rosout"), 1, 1, 100);
  reader(p, topic(p, &sensor_msgs_msg_JointState_desc, "sensor_msgs::msg::dds_::JointState_", "rt/joint_states"), 0, 0, 5);
  printf("ready\n");
  fflush(stdout);
  const std_msgs_msg_String message = {.data = (char*)"hello"};
  end += dds_time() - start; /* counts from here: making all this takes long on a busy machine */
  while (dds_time() < end) {
    for (int i = 0; i < 3; ++i) check(dds_write(out[i], &message), "write");
    dds_sleepfor(DDS_MSECS(10));
  }
}

static void undo(dds_entity_t p, dds_time_t end) {
  const dds_entity_t joints = reader(
      p, topic(p, &sensor_msgs_msg_JointState_desc, "sensor_msgs::msg::dds_::JointState_", "rt/joint_states"), 0, 0, 5);
  dds_sleepfor(DDS_SECS(1));
  check(dds_delete(joints), "delete");
  printf("undone\n");
  fflush(stdout);
  while (dds_time() < end) dds_sleepfor(DDS_MSECS(20));
}

int main(int argc, char** argv) {
  if (argc != 4) {
    fprintf(stderr, "usage: cyclone_peer read|write|latch|churn|undo DOMAIN SECONDS\n");
    return 2;
  }
  const dds_entity_t participant = dds_create_participant((dds_domainid_t)atoi(argv[2]), NULL, NULL);
  check(participant, "participant");
  const dds_time_t end = dds_time() + (dds_time_t)(atof(argv[3]) * 1e9);
  if (strcmp(argv[1], "read") == 0) read_all(participant, end);
  if (strcmp(argv[1], "write") == 0) write_all(participant, end);
  if (strcmp(argv[1], "latch") == 0) latch(participant, end);
  if (strcmp(argv[1], "churn") == 0) churn(participant, end);
  if (strcmp(argv[1], "undo") == 0) undo(participant, end);
  dds_delete(participant);
  return 0;
}
