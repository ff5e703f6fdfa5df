/* SPDX-License-Identifier: Apache-2.0 */
#include "options.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "complain.h"

static const char help[] =
    "ts-segment - separate the teeth of a scanned dental arch\n"
    "\n"
    "usage: ts-segment SCAN [options]\n"
    "\n"
    "SCAN is an STL, PLY, OBJ or OFF file.\n"
    "\n"
    "  --clicks FILE     clicks, one a line: x y z in mm on the surface; further columns, blank lines and lines\n"
    "                    that begin with # are ignored\n"
    "  --auto            the fewest clicks that cover all teeth found (the default)\n"
    "  --preset NAME     default, or paper: the paper to the letter\n"
    "  --set NAME=VALUE  any number of ts_segment_options (toothseg.h), over the preset; may be given often\n"
    "  --unit UNIT       unit of the scan: mm, cm, m or inch; what is written is in mm. Without it the scan is\n"
    "                    taken to be in mm, and refused if its size says otherwise\n"
    "  --fdi             the numbers in --labels are FDI numbers, and the report has them too; a complaint for each\n"
    "                    that is uncertain\n"
    "  --jaw NAME        upper or lower, for the numbers; without it the jaw is estimated, and where it cannot be "
    "told\n"
    "                    nothing is written\n"
    "  --threads N       worker threads; 0: one a core (the default). The result does not depend on it\n"
    "\n"
    "  --labels OUT.txt      a number a face, in the order of the faces in SCAN; 0: no tooth\n"
    "  --cuts OUT.obj        the cuts as closed polylines, an object a tooth\n"
    "  --ply OUT.ply         the cleaned mesh, coloured by tooth\n"
    "  --report OUT.json     what was done, what came of each click, and how long it took\n"
    "  --features OUT.json   the feature points, their groups and the arch curve\n"
    "  --json3dts OUT.json   FDI numbers and instances a vertex of SCAN, as the 3DTeethSeg challenge has them: a "
    "vertex\n"
    "                        is of the tooth, or gingiva, that most of its faces are of; of a tooth where as many are\n"
    "  --session FILE        the session; where the file is there already, it is gone on with first (it has its own\n"
    "                        options: --preset and --set are not for it)\n"
    "  --teeth DIR           the mesh of each tooth, tooth_LABEL.stl, or with --fdi tooth_NUMBER.stl, and "
    "gingiva.stl,\n"
    "                        cut exactly along the cuts; DIR is made if it is not there\n"
    "  --closed              these meshes watertight: every rim closed by a smooth membrane\n"
    "\n"
    "  --help, --version\n"
    "\n"
    "Exit status: 0 done; 1 a click failed or a tooth could not be closed, the others are written; 2 nothing is "
    "written.\n";

static int is_any_of(const char *text, const char *const *names, int count, int *which) {
  for (*which = 0; *which < count; ++*which)
    if (strcmp(text, names[*which]) == 0) return 1;
  return 0;
}

static int parse_preset(const char *text, ts_preset *preset) {
  static const char *const names[] = {"default", "paper"};
  static const ts_preset presets[] = {TS_PRESET_DEFAULT, TS_PRESET_PAPER};
  int i;
  if (!is_any_of(text, names, 2, &i)) return complain("--preset %s: not default or paper", text);
  *preset = presets[i];
  return 1;
}

static int parse_unit(const char *text, ts_unit *unit) {
  static const char *const names[] = {"mm", "cm", "m", "inch"};
  static const ts_unit units[] = {TS_UNIT_MM, TS_UNIT_CM, TS_UNIT_M, TS_UNIT_INCH};
  int i;
  if (!is_any_of(text, names, 4, &i)) return complain("--unit %s: not mm, cm, m or inch", text);
  *unit = units[i];
  return 1;
}

static int parse_jaw(const char *text, ts_jaw *jaw) {
  static const char *const names[] = {"upper", "lower"};
  static const ts_jaw jaws[] = {TS_JAW_UPPER, TS_JAW_LOWER};
  int i;
  if (!is_any_of(text, names, 2, &i)) return complain("--jaw %s: not upper or lower", text);
  *jaw = jaws[i];
  return 1;
}

static int parse_threads(const char *text, uint32_t *threads) {
  char *end;
  const long n = strtol(text, &end, 10);
  if (end == text || *end != '\0' || n < 0 || n > 1024)
    return complain("--threads %s: not a number from 0 to 1024", text);
  *threads = (uint32_t)n;
  return 1;
}

static int parse_setting(options *o, const char *text) {
  if (o->setting_count == SETTINGS_MOST) return complain("--set %s: more than %d of them", text, SETTINGS_MOST);
  o->settings[o->setting_count++] = text;
  return settings_apply(text, NULL);
}

/* The place where a file name given to `option` goes; NULL for any other option. */
static const char **file_of(options *o, const char *option) {
  if (strcmp(option, "--clicks") == 0) return &o->clicks;
  if (strcmp(option, "--labels") == 0) return &o->labels;
  if (strcmp(option, "--cuts") == 0) return &o->cuts;
  if (strcmp(option, "--ply") == 0) return &o->ply;
  if (strcmp(option, "--report") == 0) return &o->report;
  if (strcmp(option, "--features") == 0) return &o->features;
  if (strcmp(option, "--json3dts") == 0) return &o->json3dts;
  if (strcmp(option, "--teeth") == 0) return &o->teeth;
  if (strcmp(option, "--session") == 0) return &o->session;
  return NULL;
}

static int parse_valued(options *o, const char *option, const char *value) {
  const char **file = file_of(o, option);
  const int known = file != NULL || strcmp(option, "--preset") == 0 || strcmp(option, "--unit") == 0 ||
                    strcmp(option, "--threads") == 0 || strcmp(option, "--set") == 0 || strcmp(option, "--jaw") == 0;
  if (!known) return complain("%s: unknown option (--help lists all)", option);
  if (value == NULL || value[0] == '\0') return complain("%s: a value is missing", option);
  if (strcmp(option, "--preset") == 0) return parse_preset(value, &o->preset);
  if (strcmp(option, "--unit") == 0) return parse_unit(value, &o->unit);
  if (strcmp(option, "--jaw") == 0) return parse_jaw(value, &o->jaw);
  if (strcmp(option, "--threads") == 0) return parse_threads(value, &o->threads);
  if (strcmp(option, "--set") == 0) return parse_setting(o, value);
  *file = value;
  return 1;
}

options_result options_parse(int argc, char **argv, options *out) {
  int i, automatic = 0;
  memset(out, 0, sizeof *out);
  out->preset = TS_PRESET_DEFAULT;
  out->unit = TS_UNIT_CHECKED_MM;
  for (i = 1; i < argc; ++i) {
    if (strcmp(argv[i], "--help") == 0) {
      fputs(help, stdout);
      return OPTIONS_DONE;
    }
    if (strcmp(argv[i], "--version") == 0) {
      printf("ts-segment %s\n", ts_version());
      return OPTIONS_DONE;
    }
    if (strcmp(argv[i], "--auto") == 0) {
      automatic = 1;
    } else if (strcmp(argv[i], "--fdi") == 0) {
      out->fdi = 1;
    } else if (strcmp(argv[i], "--closed") == 0) {
      out->closed = 1;
    } else if (argv[i][0] == '-') {
      if (!parse_valued(out, argv[i], i + 1 < argc ? argv[i + 1] : NULL)) return OPTIONS_BAD;
      ++i;
    } else if (out->scan != NULL) {
      complain("%s: a second scan; one at a time", argv[i]);
      return OPTIONS_BAD;
    } else {
      out->scan = argv[i];
    }
  }
  if (out->scan == NULL || out->scan[0] == '\0') {
    complain("no scan given (--help says how)");
    return OPTIONS_BAD;
  }
  if (out->closed && out->teeth == NULL) {
    complain("--closed: without --teeth there is nothing to close");
    return OPTIONS_BAD;
  }
  if (automatic && out->clicks != NULL) {
    complain("--auto and --clicks %s exclude each other", out->clicks);
    return OPTIONS_BAD;
  }
  return OPTIONS_RUN;
}
