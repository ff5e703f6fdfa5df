/* SPDX-License-Identifier: Apache-2.0
 * The same bytes on every thread of a Windows program. Where a thread begins as Windows begins it, the x87 rounds to 53
 * bits; in one that MinGW-w64's run-time library began, to 64; and a program may have set 24. No result depends on
 * that, and the library leaves it as it is. */
#include <stdlib.h>
#include <string.h>
#include <windows.h>

#include "fixture.h"
#include "harness.h"

enum { BITS_24 = 0x007f, BITS_53 = 0x027f, BITS_64 = 0x037f };

static mesh arch;

static void set_word(unsigned short word) {
  __asm__ __volatile__("fldcw %0" : : "m"(word));
}
static unsigned short word_now(void) {
  unsigned short word;
  __asm__ __volatile__("fnstcw %0" : "=m"(word));
  return word;
}

static mesh copy_of(const mesh *m) {
  mesh copy = *m;
  copy.xyz = must_have(3 * sizeof *m->xyz * m->vertices);
  copy.triangles = must_have(3 * sizeof *m->triangles * m->faces);
  copy.labels = must_have(sizeof *m->labels * m->faces);
  memcpy(copy.xyz, m->xyz, 3 * sizeof *m->xyz * m->vertices);
  memcpy(copy.triangles, m->triangles, 3 * sizeof *m->triangles * m->faces);
  memcpy(copy.labels, m->labels, sizeof *m->labels * m->faces);
  return copy;
}

/* Features, all teeth with their numbers, and the session of them. */
typedef struct made {
  uint32_t threads;
  unsigned short before, after;
  bytes features, segmentation, session;
} made;

static void make(made *m) {
  scan s;
  uint32_t size = 0;
  m->before = word_now();
  s = scan_of(copy_of(&arch), m->threads);
  CHECK_STATUS(ts_segment_all(s.segmentation, NULL), TS_OK);
  CHECK_STATUS(ts_assign_numbers(s.segmentation, NULL), TS_OK);
  m->features = dump_features(s.features);
  m->segmentation = dump_segmentation(s.segmentation);
  CHECK_STATUS(ts_session_write(s.segmentation, NULL, 0, &size), TS_OK);
  m->session.data = must_have(size);
  m->session.size = size;
  CHECK_STATUS(ts_session_write(s.segmentation, (char *)m->session.data, size, &size), TS_OK);
  free_scan(&s);
  m->after = word_now();
}

static DWORD WINAPI make_on_thread(void *m) {
  make(m);
  return 0;
}

static void free_made(made *m) {
  free_bytes(&m->features);
  free_bytes(&m->segmentation);
  free_bytes(&m->session);
}

static void check_alike(const made *a, const made *b) {
  CHECK(a->before == a->after);
  CHECK(a->segmentation.size > 0 && a->session.size > 0);
  CHECK(same_bytes(&a->features, &b->features));
  CHECK(same_bytes(&a->segmentation, &b->segmentation));
  CHECK(same_bytes(&a->session, &b->session));
}

static void results_do_not_depend_on_the_precision(void) {
  static const unsigned short words[] = {BITS_24, BITS_53, BITS_64};
  const unsigned short at_first = word_now();
  made expected, got;
  uint32_t threads, i;
  memset(&expected, 0, sizeof expected);
  expected.threads = 1;
  make(&expected);
  for (threads = 1; threads <= 2; ++threads)
    for (i = 0; i < 3; ++i) {
      harness_case("word %x, %u threads", words[i], threads);
      memset(&got, 0, sizeof got);
      got.threads = threads;
      set_word(words[i]);
      make(&got);
      set_word(at_first);
      CHECK(got.before == words[i]);
      check_alike(&got, &expected);
      free_made(&got);
    }
  for (threads = 1; threads <= 2; ++threads) {
    HANDLE thread;
    harness_case("a thread of Windows', %u threads", threads);
    memset(&got, 0, sizeof got);
    got.threads = threads;
    thread = CreateThread(NULL, 0, make_on_thread, &got, 0, NULL);
    REQUIRE(thread != NULL);
    CHECK(WaitForSingleObject(thread, INFINITE) == WAIT_OBJECT_0);
    CloseHandle(thread);
    check_alike(&got, &expected);
    free_made(&got);
  }
  harness_case(NULL);
  free_made(&expected);
}

int main(void) {
  arch = make_arch(12000);
  RUN(results_do_not_depend_on_the_precision);
  free_mesh(&arch);
  return harness_finish();
}
