/* What every consumer prints. SPDX-License-Identifier: Apache-2.0 */
#ifndef SUMMARY_H
#define SUMMARY_H
#include <stdint.h>
#include <stdio.h>

/* The number of different labels below 64 (of an arch: the gingiva and at most 16 teeth), and FNV-1a over all of them.
 */
static void print_summary(const uint32_t *labels, uint32_t faces) {
  uint64_t seen = 0, hash = 14695981039346656037u;
  uint32_t i, count = 0;
  for (i = 0; i < faces; ++i) {
    seen |= (uint64_t)1 << (labels[i] & 63);
    hash = (hash ^ labels[i]) * 1099511628211u;
  }
  for (; seen; seen &= seen - 1) ++count;
  printf("%u labels on %u faces, checksum %08x\n", (unsigned)count, (unsigned)faces, (unsigned)(hash >> 32));
}
#endif
