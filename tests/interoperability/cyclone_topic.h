/* What the programs on Cyclone DDS share. Each includes it once. */
#pragma once

#include <dds/dds.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Ends the program, exit code 2, where `code` is an error of Cyclone DDS. */
static void check(dds_return_t code, const char* what) {
  if (code >= 0) return;
  fprintf(stderr, "%s: %s: %s\n", program_invocation_short_name, what, dds_strretcode(-code));
  exit(2);
}

/* idlc knows nothing of ROS 2's names for types: the same layout under the name that ROS 2 uses. */
static dds_entity_t topic(dds_entity_t participant, const dds_topic_descriptor_t* type, const char* ros_type,
                          const char* name) {
  dds_topic_descriptor_t* renamed = malloc(sizeof *renamed); /* lives as long as the process */
  memcpy(renamed, type, sizeof *renamed);
  *(const char**)&renamed->m_typename = ros_type;
  const dds_entity_t made = dds_create_topic(participant, renamed, name, NULL, NULL);
  check(made, name);
  return made;
}
