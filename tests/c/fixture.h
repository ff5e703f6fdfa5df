/* Meshes and scans to test with. SPDX-License-Identifier: Apache-2.0 */
#ifndef FIXTURE_H
#define FIXTURE_H

#include <toothseg.h>

typedef struct mesh {
  double *xyz;
  uint32_t vertices;
  uint32_t *triangles;
  uint32_t faces;
  uint32_t *labels; /* of an arch: a face, 0 gingiva; else NULL */
  uint32_t teeth;   /* of an arch */
} mesh;

/* All exit the program where there is no memory or the generator fails: without them nothing can be tested. An arch
 * that another program of the run has made is read from the folder that TOOTHSEG_TEST_ARCHES names. */
mesh make_arch(uint32_t triangles);
mesh make_crowded_arch(uint32_t triangles, double crowding, uint32_t seed); /* upper */
mesh make_sphere(double radius, uint32_t rings);                            /* around the origin, closed */
mesh make_plane(double side, uint32_t cells);                               /* in z = 0, from the origin */
void free_mesh(mesh *m);

ts_mesh_input input_of(const mesh *m);

/* The triangles of a large scan: with AddressSanitizer, which is ten times as slow, of a smaller one. */
#ifdef TS_SANITIZED
enum { LARGE = 20000 };
#else
enum { LARGE = 60000 };
#endif

/* A scan on the way through the library as far as it is wanted. */
typedef struct scan {
  mesh arch; /* what it was made from */
  ts_context *context;
  ts_model *model;
  ts_features *features;
  ts_segmentation *segmentation;
} scan;

scan make_scan(uint32_t triangles, uint32_t threads); /* up to an unclicked segmentation, default options */
scan scan_of(mesh arch, uint32_t threads);            /* the same; the mesh is its own from then on */
void free_scan(scan *s);

ts_context *make_context(uint32_t threads);
ts_model *make_model(ts_context *context, const mesh *m);

/* Mean position of the faces of an arch that have this label: somewhere inside the tooth; the surface point nearest to
 * it lies on the tooth or at its edge. */
void label_centre(const mesh *m, uint32_t label, double xyz[3]);

/* The proposed clicks, to be freed. */
double *proposed_clicks(const ts_segmentation *segmentation, uint32_t *count);

/* Everything a segmentation can be asked for, as bytes, without the times: to compare two of them. To be freed. */
typedef struct bytes {
  unsigned char *data;
  size_t size, capacity;
} bytes;
void put_bytes(bytes *b, const void *data, size_t size);
bytes dump_features(const ts_features *features);
bytes dump_segmentation(const ts_segmentation *segmentation);
bytes dump_teeth(const ts_segmentation *segmentation); /* of these its teeth and labels, which is quick */
int same_bytes(const bytes *a, const bytes *b);
void free_bytes(bytes *b);

/* malloc that exits the program where there is no memory. */
void *must_have(size_t size);

#endif
