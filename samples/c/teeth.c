/* SPDX-License-Identifier: Apache-2.0 */
#if !defined(_WIN32)
#define _POSIX_C_SOURCE 200112L /* mkdir */
#endif

#include "teeth.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "complain.h"
#include "utf8.h"

/* The one place where a file is named for its tooth, by its label or number; 0: the gingiva. To be freed. */
static char *path_for(const char *directory, uint32_t label) {
  const size_t size = strlen(directory) + 40;
  char *path = malloc(size);
  if (path == NULL)
    complain("%s: out of memory", directory);
  else if (label == 0)
    snprintf(path, size, "%s/gingiva.stl", directory);
  else
    snprintf(path, size, "%s/tooth_%lu.stl", directory, (unsigned long)label);
  return path;
}

/* Takes over the path, which may be NULL. */
static int announce(const options *o, teeth_files *files, staging *s, char *path) {
  const char *const inputs[] = {o->scan, o->clicks}, *const outputs[] = {path};
  char **paths = realloc(files->paths, (files->count + 1) * sizeof *paths);
  if (paths == NULL || path == NULL) {
    free(path);
    if (paths != NULL) files->paths = paths;
    return path == NULL ? 0 : complain("%s: out of memory", o->teeth);
  }
  files->paths = paths;
  files->paths[files->count++] = path;
  return staging_announce(s, outputs, 1, inputs, 2);
}

int teeth_announce_gingiva(const options *o, teeth_files *files, staging *s) {
  if (o->teeth == NULL) return 1;
  if (utf8_mkdir(o->teeth) == 0)
    files->made = o->teeth;
  else if (errno != EEXIST)
    return complain("%s: cannot be made: %s", o->teeth, strerror(errno));
  return announce(o, files, s, path_for(o->teeth, 0));
}

int teeth_announce_all(const run *r, teeth_files *files, staging *s) {
  uint32_t i;
  int good = 1;
  if (r->options->teeth == NULL) return 1;
  for (i = 0; good && i < r->tooth_count; ++i)
    good = announce(r->options, files, s,
                    path_for(r->options->teeth, r->options->fdi ? r->numbers[i].fdi : r->teeth[i].label));
  return good;
}

int teeth_write(run *r, const teeth_files *files, staging *s) {
  ts_tooth_mesh_options o;
  uint32_t i;
  if (r->options->teeth == NULL) return 1;
  if (ts_tooth_mesh_options_init(&o, sizeof o) != TS_OK) return complain_status(r->options->teeth, TS_E_STRUCT_SIZE);
  o.closed = r->options->closed != 0;
  for (i = 0; i < files->count; ++i) {
    const char *temporary = staging_by_path(s, files->paths[i]);
    ts_mesh *mesh = NULL;
    ts_status status = i == 0 ? ts_gingiva_mesh_create(r->segmentation, &o, NULL, &mesh)
                              : ts_tooth_mesh_create(r->segmentation, r->teeth[i - 1].id, &o, NULL, &mesh);
    if (status == TS_E_NOT_CLOSED || status == TS_E_NO_CUT) {
      complain_status(files->paths[i], status);
      staging_leave_out(s, files->paths[i]);
      ++r->failed;
      continue;
    }
    if (status == TS_OK) status = ts_mesh_save(mesh, temporary, TS_OUTPUT_STL, NULL);
    ts_mesh_destroy(mesh);
    if (status == TS_E_FILE_WRITE)
      return complain("%s: cannot be written: %s", files->paths[i], ts_last_error_message());
    if (status != TS_OK) return complain_status(files->paths[i], status);
  }
  return 1;
}

void teeth_close(teeth_files *files) {
  uint32_t i;
  for (i = 0; i < files->count; ++i) free(files->paths[i]);
  free(files->paths);
  if (files->made != NULL) utf8_rmdir(files->made); /* which fails where something is in it */
  files->paths = NULL;
  files->count = 0;
}
