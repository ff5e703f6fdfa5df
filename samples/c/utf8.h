/* Files by names in UTF-8, on Windows too, where the C library takes them for the system's 8-bit characters.
 * SPDX-License-Identifier: Apache-2.0
 *
 * The arguments of main are UTF-8 there as well: windows_main.c is linked to each sample. */
#ifndef UTF8_H
#define UTF8_H

#include <stdio.h>
#include <sys/stat.h>
#include <sys/types.h>

#if defined(_WIN32)

typedef struct _stat64 utf8_status;

/* As the functions of the same name do: errno says why not. */
FILE *utf8_fopen(const char *path, const char *mode);
int utf8_remove(const char *path);
int utf8_rename(const char *from, const char *to);
int utf8_stat(const char *path, utf8_status *status);
int utf8_mkdir(const char *path);
int utf8_rmdir(const char *path);

#else

#include <unistd.h>

typedef struct stat utf8_status;

#define utf8_fopen fopen
#define utf8_remove remove
#define utf8_rename rename
#define utf8_stat stat
#define utf8_mkdir(path) mkdir(path, 0777)
#define utf8_rmdir rmdir

#endif
#endif
