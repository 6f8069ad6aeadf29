// SPDX-License-Identifier: BSD-3-Clause
// Peer of the DDS tests in C, with type information: Cyclone DDS of the system, output of idlc
// without -t. Reads rt/lowstate and writes rt/lowcmd (mode 1, tau 0.25, no CRC).
// Usage: dds_c_peer DOMAIN SECONDS; prints the number of LowStates.
#include <dds/dds.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "unitree_go.h"

int main(int argc, char **argv) {
  if (argc != 3) return 2;
  const dds_entity_t participant =
      dds_create_participant((dds_domainid_t)atoi(argv[1]), NULL, NULL);
  const dds_entity_t states = dds_create_topic(
      participant, &unitree_go_msg_dds__LowState__desc, "rt/lowstate", NULL, NULL);
  const dds_entity_t commands =
      dds_create_topic(participant, &unitree_go_msg_dds__LowCmd__desc, "rt/lowcmd", NULL, NULL);
  const dds_entity_t reader = dds_create_reader(participant, states, NULL, NULL);
  const dds_entity_t writer = dds_create_writer(participant, commands, NULL, NULL);
  if (reader < 0 || writer < 0) return 3;
  static unitree_go_msg_dds__LowCmd_ command;
  for (int i = 0; i < 20; ++i) {
    command.motor_cmd[i].mode = 1;
    command.motor_cmd[i].tau = 0.25F;
  }
  static unitree_go_msg_dds__LowState_ state;
  int received = 0;
  for (int k = 0; k < 250 * atoi(argv[2]); ++k) {
    void *samples[1] = {&state};
    dds_sample_info_t info[1];
    while (dds_take(reader, samples, info, 1, 1) > 0) received += info[0].valid_data;
    dds_write(writer, &command);
    dds_sleepfor(DDS_MSECS(4));
  }
  dds_delete(participant);
  printf("%d\n", received);
  return 0;
}
