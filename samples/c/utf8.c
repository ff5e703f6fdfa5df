/* SPDX-License-Identifier: Apache-2.0 */
#include "utf8.h"

#if defined(_WIN32)

#include <direct.h>
#include <errno.h>
#include <stdlib.h>
#include <wchar.h>
#include <windows.h>

/* To be freed. NULL, with errno, where the bytes are no UTF-8 or there is no memory. */
static wchar_t *wide(const char *text) {
  const int size = MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text, -1, NULL, 0);
  wchar_t *out;
  if (size == 0) return errno = EILSEQ, NULL;
  if ((out = malloc((size_t)size * sizeof *out)) == NULL) return errno = ENOMEM, NULL;
  MultiByteToWideChar(CP_UTF8, MB_ERR_INVALID_CHARS, text, -1, out, size);
  return out;
}

/* What a function says of one name. */
#define OF_WIDE(path, call)        \
  int result = -1;                 \
  wchar_t *name = wide(path);      \
  if (name != NULL) result = call; \
  free(name);                      \
  return result

FILE *utf8_fopen(const char *path, const char *mode) {
  FILE *file = NULL;
  wchar_t *name = wide(path), *how = wide(mode);
  if (name != NULL && how != NULL) file = _wfopen(name, how);
  free(name);
  free(how);
  return file;
}

int utf8_rename(const char *from, const char *to) {
  int result = -1;
  wchar_t *old_name = wide(from), *new_name = wide(to);
  if (old_name != NULL && new_name != NULL) result = _wrename(old_name, new_name);
  free(old_name);
  free(new_name);
  return result;
}

int utf8_remove(const char *path) {
  OF_WIDE(path, _wremove(name));
}

int utf8_stat(const char *path, utf8_status *status) {
  OF_WIDE(path, _wstat64(name, status));
}

int utf8_mkdir(const char *path) {
  OF_WIDE(path, _wmkdir(name));
}

int utf8_rmdir(const char *path) {
  OF_WIDE(path, _wrmdir(name));
}

#else

/* C wants a declaration in each file. */
typedef int utf8_nothing_to_do;

#endif
