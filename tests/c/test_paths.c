/* Names of files and folders: blanks, umlauts, Chinese characters, places where nothing may be written, files that
 * another program has open. Names are UTF-8 on every system. SPDX-License-Identifier: Apache-2.0 */
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200112L /* mkdir, rmdir */
#endif
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#if defined(_WIN32)
#include <direct.h>
#include <wchar.h>
#include <windows.h>
#else
#include <unistd.h>
#endif

#include "fixture.h"
#include "harness.h"

static scan s;

/* A folder and a file in it: as the library is told, and as the system itself is told, which is what shows that both
 * mean the same place. */
#if defined(_WIN32)
typedef wchar_t own;
#define OWN(text) L##text
#define open_own(path) _wfopen(path, L"rb")
#define remove_own _wremove
#define make_folder _wmkdir
#define remove_folder _wrmdir
#else
typedef char own;
#define OWN(text) text
#define open_own(path) fopen(path, "rb")
#define remove_own remove
#define make_folder(path) mkdir(path, 0755)
#define remove_folder rmdir
#endif

typedef struct place {
  const char *what, *folder, *file;
  const own *own_folder, *own_file;
} place;

#if defined(_WIN32)
#define PLACE(what, folder, file, wide_folder, wide_file) \
  { what, folder, folder "/" file, wide_folder, wide_folder L"/" wide_file }
#else
#define PLACE(what, folder, file, wide_folder, wide_file) \
  { what, folder, folder "/" file, folder, folder "/" file }
#endif

static const place places[] = {
    PLACE("blanks", "scans of today", "upper jaw 2", L"scans of today", L"upper jaw 2"),
    PLACE("umlauts", "Z\xC3\xA4hne", "M\xC3\xBCller gro\xC3\x9F", L"Z\u00E4hne", L"M\u00FCller gro\u00DF"),
    PLACE("Chinese", "\xE7\x89\x99\xE9\xBD\xBF", "\xE4\xB8\x8A\xE9\xA2\x8C", L"\u7259\u9F7F", L"\u4E0A\u988C"),
    PLACE("beyond 16 bits", "\xF0\x9F\xA6\xB7 tooth", "\xF0\x9F\xA6\xB7", L"\U0001F9B7 tooth", L"\U0001F9B7"),
};

static long size_of(const own *path) {
  FILE *file = open_own(path);
  long size = -1;
  if (file == NULL) return -1;
  if (fseek(file, 0, SEEK_END) == 0) size = ftell(file);
  fclose(file);
  return size;
}

static uint32_t faces_of(ts_model *model) {
  ts_intake_report r;
  memset(&r, 0, sizeof r);
  r.struct_size = sizeof r;
  CHECK_STATUS(ts_model_get_report(model, &r), TS_OK);
  ts_model_destroy(model);
  return r.faces;
}

static void any_name_is_written_and_read(void) {
  size_t i;
  for (i = 0; i < sizeof places / sizeof places[0]; ++i) {
    const place *p = &places[i];
    ts_model *model = NULL;
    ts_features *features = NULL;
    ts_segmentation *resumed = NULL;
    uint32_t teeth = 0, again = 0;
    harness_case("%s", p->what);
    remove_own(p->own_file);
    remove_folder(p->own_folder);
    CHECK(make_folder(p->own_folder) == 0);
    CHECK_STATUS(ts_segmentation_save(s.segmentation, p->file, TS_OUTPUT_STL, NULL, NULL), TS_OK);
    CHECK(size_of(p->own_file) > 84);
    /* Twice: the second takes the place of the first. */
    CHECK_STATUS(ts_segmentation_save(s.segmentation, p->file, TS_OUTPUT_STL, NULL, NULL), TS_OK);
    if (CHECK_STATUS(ts_model_load(s.context, p->file, NULL, NULL, &model), TS_OK)) CHECK(faces_of(model) > 5000);
    CHECK_STATUS(ts_session_save(s.segmentation, p->file), TS_OK);
    if (CHECK_STATUS(ts_session_load(s.model, p->file, NULL, &features, &resumed), TS_OK)) {
      CHECK_STATUS(ts_get_teeth(s.segmentation, NULL, 0, &teeth), TS_OK);
      CHECK_STATUS(ts_get_teeth(resumed, NULL, 0, &again), TS_OK);
      CHECK(teeth > 0 && teeth == again);
    }
    ts_segmentation_destroy(resumed);
    ts_features_destroy(features);
    CHECK(remove_own(p->own_file) == 0);
    CHECK(remove_folder(p->own_folder) == 0); /* nothing else is left in it */
  }
}

/* The message has the name as it was given. */
static void what_is_not_there_is_named(void) {
  ts_model *model = NULL;
  CHECK_STATUS(ts_model_load(s.context, "Z\xC3\xA4hne/\xE7\x89\x99.stl", NULL, NULL, &model), TS_E_FILE_OPEN);
  CHECK(strstr(ts_last_error_message(), "Z\xC3\xA4hne/\xE7\x89\x99.stl") != NULL);
  CHECK(model == NULL);
}

/* Elsewhere than on Windows a name is bytes, and these are one, of a file that is not there. */
static void bytes_that_are_no_text(void) {
  ts_model *model = NULL;
  CHECK_STATUS(ts_model_load(s.context, "\xFF\xFE.stl", NULL, NULL, &model), TS_E_FILE_OPEN);
#if defined(_WIN32)
  CHECK_STATUS(ts_segmentation_save(s.segmentation, "\xFF\xFE.stl", TS_OUTPUT_STL, NULL, NULL), TS_E_FILE_WRITE);
  CHECK_STATUS(ts_session_save(s.segmentation, "\xFF\xFE.stl"), TS_E_FILE_WRITE);
#endif
}

/* Linux keeps /sys for itself, from root too, and under Wine it is there as well. */
static void a_folder_that_is_read_only(void) {
  struct stat there;
  if (stat("/sys", &there) != 0) return;
  CHECK_STATUS(ts_segmentation_save(s.segmentation, "/sys/tooth.stl", TS_OUTPUT_STL, NULL, NULL), TS_E_FILE_WRITE);
  CHECK(strstr(ts_last_error_message(), "/sys/tooth.stl") != NULL);
  CHECK_STATUS(ts_session_save(s.segmentation, "/sys/session.json"), TS_E_FILE_WRITE);
}

static void write_old(const char *path) {
  FILE *file = fopen(path, "wb");
  if (!CHECK(file != NULL)) return;
  fputs("old", file);
  fclose(file);
}

#if defined(_WIN32)

/* What `hold` below does, as another process: has the file open, for itself alone or for readers beside it, until its
 * standard input ends. */
static int hold(const char *path, DWORD share) {
  const HANDLE file = CreateFileA(path, GENERIC_READ, share, NULL, OPEN_EXISTING, 0, NULL);
  if (file == INVALID_HANDLE_VALUE) return 1;
  putchar('h');
  fflush(stdout);
  while (getchar() != EOF) {
  }
  CloseHandle(file);
  return 0;
}

typedef struct holder {
  HANDLE process, input;
} holder;

static int begin(holder *h, const char *how) {
  SECURITY_ATTRIBUTES inherited = {sizeof inherited, NULL, TRUE};
  STARTUPINFOA start;
  PROCESS_INFORMATION made;
  HANDLE child_in, child_out, output;
  DWORD n = 0;
  char program[1024], line[2048], said = 0;
  GetModuleFileNameA(NULL, program, sizeof program);
  snprintf(line, sizeof line, "\"%s\" %s", program, how);
  if (!CreatePipe(&child_in, &h->input, &inherited, 0) || !CreatePipe(&output, &child_out, &inherited, 0)) return 0;
  SetHandleInformation(h->input, HANDLE_FLAG_INHERIT, 0);
  SetHandleInformation(output, HANDLE_FLAG_INHERIT, 0);
  memset(&start, 0, sizeof start);
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdInput = child_in;
  start.hStdOutput = child_out;
  start.hStdError = GetStdHandle(STD_ERROR_HANDLE);
  if (!CreateProcessA(NULL, line, NULL, NULL, TRUE, 0, NULL, NULL, &start, &made)) return 0;
  CloseHandle(child_in);
  CloseHandle(child_out);
  CloseHandle(made.hThread);
  h->process = made.hProcess;
  ReadFile(output, &said, 1, &n, NULL); /* ends where the other process does */
  CloseHandle(output);
  return said == 'h';
}

static void end(holder *h) {
  DWORD result = 1;
  CloseHandle(h->input);
  WaitForSingleObject(h->process, INFINITE);
  CHECK(GetExitCodeProcess(h->process, &result) && result == 0);
  CloseHandle(h->process);
}

#endif

/* On Windows such a file is not replaced, and stays as it is; elsewhere it is, and who has it open keeps the old one.
 */
static void a_file_that_another_has_open(void) {
  ts_model *model = NULL;
  make_folder(OWN("held"));
  write_old("held/file");
#if defined(_WIN32)
  {
    holder h;
    harness_case("for itself alone");
    REQUIRE(begin(&h, "alone"));
    CHECK_STATUS(ts_model_load(s.context, "held/file", NULL, NULL, &model), TS_E_FILE_OPEN);
    CHECK_STATUS(ts_segmentation_save(s.segmentation, "held/file", TS_OUTPUT_STL, NULL, NULL), TS_E_FILE_WRITE);
    CHECK(strstr(ts_last_error_message(), "held/file") != NULL);
    CHECK_STATUS(ts_session_save(s.segmentation, "held/file"), TS_E_FILE_WRITE);
    end(&h);
    CHECK(size_of(L"held/file") == 3);
    CHECK_STATUS(ts_segmentation_save(s.segmentation, "held/file", TS_OUTPUT_STL, NULL, NULL), TS_OK);
    harness_case("for readers");
    REQUIRE(begin(&h, "shared"));
    if (CHECK_STATUS(ts_model_load(s.context, "held/file", NULL, NULL, &model), TS_OK)) CHECK(faces_of(model) > 5000);
    CHECK_STATUS(ts_session_save(s.segmentation, "held/file"), TS_E_FILE_WRITE);
    end(&h);
    CHECK(size_of(L"held/file") > 84);
  }
#else
  {
    FILE *file = fopen("held/file", "rb");
    char text[8] = "";
    REQUIRE(file != NULL);
    CHECK_STATUS(ts_segmentation_save(s.segmentation, "held/file", TS_OUTPUT_STL, NULL, NULL), TS_OK);
    CHECK(fread(text, 1, sizeof text - 1, file) == 3 && strcmp(text, "old") == 0);
    fclose(file);
    if (CHECK_STATUS(ts_model_load(s.context, "held/file", NULL, NULL, &model), TS_OK)) CHECK(faces_of(model) > 5000);
  }
#endif
  remove("held/file");
  CHECK(remove_folder(OWN("held")) == 0); /* no temporary file is left */
}

int main(int argc, char **argv) {
#if defined(_WIN32)
  if (argc == 2) return hold("held/file", strcmp(argv[1], "shared") == 0 ? FILE_SHARE_READ : 0);
#else
  (void)argc, (void)argv;
#endif
  s = make_scan(8000, 0);
  if (ts_segment_all(s.segmentation, NULL) != TS_OK) return 3;
  RUN(any_name_is_written_and_read);
  RUN(what_is_not_there_is_named);
  RUN(bytes_that_are_no_text);
  RUN(a_folder_that_is_read_only);
  RUN(a_file_that_another_has_open);
  free_scan(&s);
  return harness_finish();
}
