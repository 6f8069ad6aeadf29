/* SPDX-License-Identifier: BSD-3-Clause
 *
 * What the output of idlc needs of Cyclone DDS: the layout of a topic descriptor and the operations
 * that describe a type. The declarations match Cyclone DDS 0.10.2; libddsc 11.0.1 reads the same
 * layout. No header of Cyclone DDS is needed, because no Python wheel contains them. */
#ifndef SUREFOOT_DDS_PUBLIC_IMPL_H
#define SUREFOOT_DDS_PUBLIC_IMPL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define dds_alignof _Alignof

enum {
  DDS_OP_RTS = 0x00000000,
  DDS_OP_ADR = 0x01000000,
  DDS_OP_TYPE_1BY = 0x00010000,
  DDS_OP_TYPE_2BY = 0x00020000,
  DDS_OP_TYPE_4BY = 0x00030000,
  DDS_OP_TYPE_8BY = 0x00040000,
  DDS_OP_TYPE_STR = 0x00050000,
  DDS_OP_TYPE_SEQ = 0x00070000,
  DDS_OP_TYPE_ARR = 0x00080000,
  DDS_OP_TYPE_EXT = 0x000D0000,
  DDS_OP_TYPE_BLN = 0x000E0000,
  DDS_OP_SUBTYPE_1BY = 0x00000100,
  DDS_OP_SUBTYPE_2BY = 0x00000200,
  DDS_OP_SUBTYPE_4BY = 0x00000300,
  DDS_OP_SUBTYPE_STU = 0x00000A00,
  DDS_OP_FLAG_FP = 0x00000002,
  DDS_OP_FLAG_SGN = 0x00000004,
  DDS_TOPIC_FIXED_SIZE = 0x00000010
};

typedef struct dds_key_descriptor {
  const char *m_name;
  uint32_t m_offset;
  uint32_t m_idx;
} dds_key_descriptor_t;

struct dds_type_meta_ser {
  unsigned char *data;
  uint32_t sz;
};

typedef struct dds_topic_descriptor {
  const uint32_t m_size;
  const uint32_t m_align;
  const uint32_t m_flagset;
  const uint32_t m_nkeys;
  const char *m_typename;
  const dds_key_descriptor_t *m_keys;
  const uint32_t m_nops;
  const uint32_t *m_ops;
  const char *m_meta;
  struct dds_type_meta_ser type_information; /* empty: idlc -t */
  struct dds_type_meta_ser type_mapping;     /* empty: idlc -t */
  const uint32_t restrict_data_representation;
} dds_topic_descriptor_t;

#endif
