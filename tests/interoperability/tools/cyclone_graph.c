/* What a ROS 2 tool's middleware gets to know of a domain, seen by Cyclone DDS, which shares no code with goalnet:
 *   cyclone_graph DOMAIN SECONDS humble|jazzy [MILLISECONDS]
 * Prints every MILLISECONDS (250), ended by a line "end" with the seconds since the start, one line for each
 *   participant GUID NAME USER_DATA
 *   writer|reader GUID PARTICIPANT TOPIC TYPE RELIABLE TRANSIENT_LOCAL DEADLINE LIVELINESS LEASE USER_DATA
 *   node PARTICIPANT NAMESPACE NAME readers GUID… writers GUID…
 * GUIDs and USER_DATA in hexadecimal digits ("-" for none), durations in seconds or "infinite", liveliness as DDS counts
 * it (0: automatic). Cyclone's built-in topics do not tell the lifespan, not even of its own writers.
 */
#include <dds/dds.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "humble_graph.h"
#include "rmw_dds_common.h"

enum { MOST = 4000 };

static dds_entity_t check(dds_entity_t code, const char* what) {
  if (code < 0) {
    fprintf(stderr, "cyclone_graph: %s: %s\n", what, dds_strretcode(-code));
    exit(2);
  }
  return code;
}

static void print_hex(const void* bytes, size_t size) {
  const unsigned char* at = bytes;
  if (size == 0) printf("-");
  for (size_t i = 0; i < size; ++i) printf("%02x", at[i]);
}

static void print_user_data(const dds_qos_t* qos) {
  void* data = NULL;
  size_t size = 0;
  if (!dds_qget_userdata(qos, &data, &size)) size = 0;
  print_hex(data, size);
  dds_free(data);
}

static void print_duration(bool known, dds_duration_t span) {
  if (!known || span == DDS_INFINITY) {
    printf(" infinite");
  } else {
    printf(" %.9g", (double)span * 1e-9);
  }
}

static void print_participant(const dds_builtintopic_participant_t* one) {
  char* name = NULL;
  printf("participant ");
  print_hex(one->key.v, sizeof one->key.v);
  printf(" %s ", dds_qget_entity_name(one->qos, &name) && name != NULL && name[0] != '\0' ? name : "-");
  print_user_data(one->qos);
  printf("\n");
  dds_free(name);
}

static void print_endpoint(const char* kind, const dds_builtintopic_endpoint_t* one) {
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_liveliness_kind_t liveliness = DDS_LIVELINESS_AUTOMATIC;
  dds_duration_t blocking, deadline = DDS_INFINITY, lease = DDS_INFINITY;
  dds_qget_reliability(one->qos, &reliability, &blocking);
  dds_qget_durability(one->qos, &durability);
  printf("%s ", kind);
  print_hex(one->key.v, sizeof one->key.v);
  printf(" ");
  print_hex(one->participant_key.v, sizeof one->participant_key.v);
  printf(" %s %s %d %d", one->topic_name, one->type_name, reliability == DDS_RELIABILITY_RELIABLE,
         durability == DDS_DURABILITY_TRANSIENT_LOCAL);
  print_duration(dds_qget_deadline(one->qos, &deadline), deadline);
  const bool live = dds_qget_liveliness(one->qos, &liveliness, &lease);
  printf(" %d", (int)liveliness);
  print_duration(live, lease);
  printf(" ");
  print_user_data(one->qos);
  printf("\n");
}

static dds_entity_t builtin(dds_entity_t participant, dds_entity_t topic) {
  return check(dds_create_reader(participant, topic, NULL, NULL), "builtin reader");
}

/* Calls `print` with each instance that is alive. */
#define FOR_EACH_ALIVE(reader, print)                                                            \
  do {                                                                                           \
    void* samples[MOST] = {0};                                                                   \
    static dds_sample_info_t infos[MOST];                                                        \
    const int count = dds_read(reader, samples, infos, MOST, MOST);                              \
    for (int i = 0; i < count; ++i) {                                                            \
      if (infos[i].valid_data && infos[i].instance_state == DDS_ALIVE_INSTANCE_STATE) print;     \
    }                                                                                            \
    if (count > 0) dds_return_loan(reader, samples, count);                                      \
  } while (0)

/* Messages of ros_discovery_info are printed as they arrive: the last one of a participant is in force. */
#define PRINT_NODES(Info, NodeInfo, gid_bytes)                                                   \
  static void print_nodes_##NodeInfo(const Info* message) {                                      \
    printf("nodes ");                                                                            \
    print_hex(message->gid.data, 16);                                                            \
    printf("\n");                                                                                \
    for (uint32_t n = 0; n < message->node_entities_info_seq._length; ++n) {                     \
      const NodeInfo* node = &message->node_entities_info_seq._buffer[n];                        \
      printf("node ");                                                                           \
      print_hex(message->gid.data, 16);                                                          \
      printf(" %s %s readers", node->node_namespace, node->node_name);                           \
      for (uint32_t i = 0; i < node->reader_gid_seq._length; ++i) {                              \
        printf(" ");                                                                             \
        print_hex(node->reader_gid_seq._buffer[i].data, 16);                                     \
      }                                                                                          \
      printf(" writers");                                                                        \
      for (uint32_t i = 0; i < node->writer_gid_seq._length; ++i) {                              \
        printf(" ");                                                                             \
        print_hex(node->writer_gid_seq._buffer[i].data, 16);                                     \
      }                                                                                          \
      printf("\n");                                                                              \
    }                                                                                            \
  }
PRINT_NODES(rmw_dds_common_msg_ParticipantEntitiesInfo, rmw_dds_common_msg_NodeEntitiesInfo, 16)
PRINT_NODES(humble_graph_ParticipantEntitiesInfo, humble_graph_NodeEntitiesInfo, 24)

int main(int argc, char** argv) {
  if (argc != 4 && argc != 5) return 13;
  const dds_duration_t pause = DDS_MSECS(argc == 5 ? atoi(argv[4]) : 250);
  const dds_time_t start = dds_time();
  const bool humble = strcmp(argv[3], "humble") == 0;
  const dds_entity_t participant =
      check(dds_create_participant((dds_domainid_t)atoi(argv[1]), NULL, NULL), "participant");
  const dds_entity_t participants = builtin(participant, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT);
  const dds_entity_t writers = builtin(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION);
  const dds_entity_t readers = builtin(participant, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION);
  dds_topic_descriptor_t renamed =
      humble ? humble_graph_ParticipantEntitiesInfo_desc : rmw_dds_common_msg_ParticipantEntitiesInfo_desc;
  *(const char**)&renamed.m_typename = "rmw_dds_common::msg::dds_::ParticipantEntitiesInfo_";
  const dds_entity_t topic =
      check(dds_create_topic(participant, &renamed, "ros_discovery_info", NULL, NULL), "topic");
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
  dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
  const dds_entity_t graph = check(dds_create_reader(participant, topic, qos, NULL), "graph reader");
  dds_delete_qos(qos);
  printf("ready\n");
  fflush(stdout);
  const dds_time_t end = start + (dds_time_t)(atof(argv[2]) * 1e9);
  while (dds_time() < end) {
    dds_sleepfor(pause);
    FOR_EACH_ALIVE(participants, print_participant(samples[i]));
    FOR_EACH_ALIVE(writers, print_endpoint("writer", samples[i]));
    FOR_EACH_ALIVE(readers, print_endpoint("reader", samples[i]));
    void* samples[MOST] = {0};
    static dds_sample_info_t infos[MOST];
    const int count = dds_take(graph, samples, infos, MOST, MOST);
    for (int i = 0; i < count; ++i) {
      if (!infos[i].valid_data) continue;
      if (humble) {
        print_nodes_humble_graph_NodeEntitiesInfo(samples[i]);
      } else {
        print_nodes_rmw_dds_common_msg_NodeEntitiesInfo(samples[i]);
      }
    }
    if (count > 0) dds_return_loan(graph, samples, count);
    printf("end %.3f\n", (double)(dds_time() - start) * 1e-9);
    fflush(stdout);
  }
  dds_delete(participant);
  return 0;
}
