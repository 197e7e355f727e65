/* Services as rmw_cyclonedds makes them, on Cyclone DDS, sharing no code with goalnet:
 *   cyclone_services call DOMAIN COUNT        calls /add COUNT times, one after the other: prints "sum N"; before
 *                                             that, on standard error, "found MILLISECONDS" after its start
 *   cyclone_services state DOMAIN NODE        asks NODE/get_state once: prints "state ID LABEL"
 *   cyclone_services serve DOMAIN SECONDS     serves /add, prints "met a client" once it can answer one
 * A call waits five seconds for its service and as long for its answer; exit code 1 where either is missing.
 */
#define _GNU_SOURCE
#include <dds/dds.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "../cyclone_topic.h"
#include "cyclone_services.h"

#define PATIENCE DDS_SECS(5)

static dds_time_t start;

typedef struct {
  dds_entity_t writer, reader;
  uint64_t number; /* of a client: the instance handle of its writer */
} pair_t;

/* Unlike that of any other client. */
static const char* client_id(void) {
  static char id[64];
  snprintf(id, sizeof id, "clientid= 1.10.%lx.%" PRIx64 ";", (long)getpid(), (uint64_t)dds_time());
  return id;
}

/* The writer first, then the reader, both with the same id in USER_DATA. */
static pair_t make_pair(dds_entity_t participant, dds_entity_t out, dds_entity_t in, const char* user_data) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_INFINITY);
  dds_qset_durability(qos, DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
  dds_qset_userdata(qos, user_data, strlen(user_data));
  pair_t pair;
  pair.writer = dds_create_writer(participant, out, qos, NULL);
  check(pair.writer, "writer");
  pair.reader = dds_create_reader(participant, in, qos, NULL);
  check(pair.reader, "reader");
  check(dds_get_instance_handle(pair.writer, &pair.number), "instance handle");
  dds_delete_qos(qos);
  return pair;
}

/* How rmw_cyclonedds sees that a service is there that says no serviceid: something is matched on both sides. */
static void wait_for_service(pair_t pair) {
  const dds_time_t end = dds_time() + PATIENCE;
  dds_instance_handle_t matched[4];
  while (dds_get_matched_subscriptions(pair.writer, matched, 4) <= 0 ||
         dds_get_matched_publications(pair.reader, matched, 4) <= 0) {
    if (dds_time() > end) {
      fprintf(stderr, "cyclone_services: no such service\n");
      exit(1);
    }
    dds_sleepfor(DDS_MSECS(1));
  }
}

/* Waits for the reply that begins with these two numbers; what all replies begin with is read as the first. */
static void* wait_for_reply(pair_t pair, int64_t sequence) {
  const dds_time_t end = dds_time() + PATIENCE;
  while (dds_time() < end) {
    void* samples[1] = {NULL};
    dds_sample_info_t info;
    while (dds_take(pair.reader, samples, &info, 1, 1) > 0) {
      const with_header_AddTwoInts_Response* reply = samples[0];
      if (info.valid_data && reply->client == pair.number && reply->count == sequence) return samples[0];
      dds_return_loan(pair.reader, samples, 1);
      samples[0] = NULL;
    }
    dds_sleepfor(DDS_MSECS(1));
  }
  fprintf(stderr, "cyclone_services: no answer to %" PRId64 "\n", sequence);
  exit(1);
}

static dds_entity_t add_request(dds_entity_t p) {
  return topic(p, &with_header_AddTwoInts_Request_desc, "example_interfaces::srv::dds_::AddTwoInts_Request_",
               "rq/addRequest");
}

static dds_entity_t add_reply(dds_entity_t p) {
  return topic(p, &with_header_AddTwoInts_Response_desc, "example_interfaces::srv::dds_::AddTwoInts_Response_",
               "rr/addReply");
}

static void call(dds_entity_t p, int count) {
  const pair_t pair = make_pair(p, add_request(p), add_reply(p), client_id());
  wait_for_service(pair);
  fprintf(stderr, "found %d\n", (int)((dds_time() - start) / 1000000));
  for (int i = 1; i <= count; ++i) {
    const with_header_AddTwoInts_Request request = {pair.number, i, i, 1000};
    check(dds_write(pair.writer, &request), "write");
    printf("sum %" PRId64 "\n", ((with_header_AddTwoInts_Response*)wait_for_reply(pair, i))->sum);
  }
}

static void state(dds_entity_t p, const char* node) {
  char request_topic[256], reply_topic[256];
  snprintf(request_topic, sizeof request_topic, "rq%s/get_stateRequest", node);
  snprintf(reply_topic, sizeof reply_topic, "rr%s/get_stateReply", node);
  const pair_t pair = make_pair(
      p, topic(p, &with_header_GetState_Request_desc, "lifecycle_msgs::srv::dds_::GetState_Request_", request_topic),
      topic(p, &with_header_GetState_Response_desc, "lifecycle_msgs::srv::dds_::GetState_Response_", reply_topic),
      client_id());
  wait_for_service(pair);
  const with_header_GetState_Request request = {pair.number, 1, 0};
  check(dds_write(pair.writer, &request), "write");
  const with_header_GetState_Response* reply = wait_for_reply(pair, 1);
  printf("state %u %s\n", (unsigned)reply->id, reply->label);
}

static void serve(dds_entity_t p, dds_time_t end) {
  const pair_t pair = make_pair(p, add_reply(p), add_request(p), "serviceid= 1.10.aa.3;");
  wait_for_service(pair); /* here: for a client */
  printf("met a client\n");
  fflush(stdout);
  while (dds_time() < end) {
    void* samples[1] = {NULL};
    dds_sample_info_t info;
    while (dds_take(pair.reader, samples, &info, 1, 1) > 0) {
      const with_header_AddTwoInts_Request* request = samples[0];
      if (info.valid_data) {
        const with_header_AddTwoInts_Response reply = {request->client, request->count, request->a + request->b};
        check(dds_write(pair.writer, &reply), "write");
      }
      dds_return_loan(pair.reader, samples, 1);
      samples[0] = NULL;
    }
    dds_sleepfor(DDS_MSECS(1));
  }
}

int main(int argc, char** argv) {
  if (argc != 4) {
    fprintf(stderr, "usage: cyclone_services call DOMAIN COUNT | state DOMAIN NODE | serve DOMAIN SECONDS\n");
    return 2;
  }
  start = dds_time();
  const dds_entity_t participant = dds_create_participant((dds_domainid_t)atoi(argv[2]), NULL, NULL);
  check(participant, "participant");
  if (strcmp(argv[1], "call") == 0) call(participant, atoi(argv[3]));
  if (strcmp(argv[1], "state") == 0) state(participant, argv[3]);
  if (strcmp(argv[1], "serve") == 0) serve(participant, dds_time() + (dds_time_t)(atof(argv[3]) * 1e9));
  dds_delete(participant);
  return 0;
}
