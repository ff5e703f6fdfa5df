#include <cstdio>

#include "api/guard.h"

namespace ts::api {
namespace {

// Fixed size: keeping a message must not need memory when memory is what ran out.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): each thread's own
thread_local char last_message[512] = "";

}  // namespace

void keep_message(const char *function, const char *what) noexcept {
  static_cast<void>(std::snprintf(last_message, sizeof last_message, "%s: %s", function, what));  // cut off if too long
  // One line, whatever a file is called.
  for (char *c = last_message; *c; ++c)
    if (*c == '\n' || *c == '\r') *c = '?';
}

ts_status status_of(Fault fault) noexcept {
  switch (fault) {
    case Fault::invalid_argument: return TS_E_INVALID_ARGUMENT;
    case Fault::null: return TS_E_NULL;
    case Fault::struct_size: return TS_E_STRUCT_SIZE;
    case Fault::buffer_too_small: return TS_E_BUFFER_TOO_SMALL;
    case Fault::not_found: return TS_E_NOT_FOUND;
    case Fault::mismatch: return TS_E_MISMATCH;
    case Fault::out_of_memory: return TS_E_OUT_OF_MEMORY;
    case Fault::cancelled: return TS_E_CANCELLED;
    case Fault::internal: return TS_E_INTERNAL;
    case Fault::file_open: return TS_E_FILE_OPEN;
    case Fault::file_format: return TS_E_FILE_FORMAT;
    case Fault::file_truncated: return TS_E_FILE_TRUNCATED;
    case Fault::file_trailing: return TS_E_FILE_TRAILING;
    case Fault::file_count: return TS_E_FILE_COUNT;
    case Fault::file_syntax: return TS_E_FILE_SYNTAX;
    case Fault::file_write: return TS_E_FILE_WRITE;
    case Fault::file_newer: return TS_E_FILE_NEWER;
    case Fault::mesh_empty: return TS_E_MESH_EMPTY;
    case Fault::mesh_non_finite: return TS_E_MESH_NON_FINITE;
    case Fault::mesh_index_range: return TS_E_MESH_INDEX_RANGE;
    case Fault::mesh_units: return TS_E_MESH_UNITS;
    case Fault::mesh_too_large: return TS_E_MESH_TOO_LARGE;
    case Fault::no_teeth: return TS_E_NO_TEETH;
    case Fault::no_constraint: return TS_E_NO_CONSTRAINT;
    case Fault::click_off_surface: return TS_E_CLICK_OFF_SURFACE;
    case Fault::click_on_gingiva: return TS_E_CLICK_ON_GINGIVA;
    case Fault::no_cut: return TS_E_NO_CUT;
    case Fault::solver: return TS_E_SOLVER;
    case Fault::locked: return TS_E_LOCKED;
    case Fault::no_change: return TS_E_NO_CHANGE;
    case Fault::no_history: return TS_E_NO_HISTORY;
    case Fault::too_many_teeth: return TS_E_TOO_MANY_TEETH;
    case Fault::number_jaw: return TS_E_NUMBER_JAW;
    case Fault::number_taken: return TS_E_NUMBER_TAKEN;
    case Fault::number_order: return TS_E_NUMBER_ORDER;
    case Fault::edit_nothing: return TS_E_EDIT_NOTHING;
    case Fault::edit_on_tooth: return TS_E_EDIT_ON_TOOTH;
    case Fault::edit_crossing: return TS_E_EDIT_CROSSING;
    case Fault::edit_off_cut: return TS_E_EDIT_OFF_CUT;
    case Fault::edit_no_loop: return TS_E_EDIT_NO_LOOP;
    case Fault::not_closed: return TS_E_NOT_CLOSED;
  }
  return TS_E_INTERNAL;
}

}  // namespace ts::api

const char *ts_last_error_message(void) {
  return ts::api::last_message;
}

const char *ts_status_name(ts_status status) {
#define TS_NAME(s) \
  case s: return #s
  switch (ts::api::caller_number(status)) {
    TS_NAME(TS_OK);
    TS_NAME(TS_E_INVALID_ARGUMENT);
    TS_NAME(TS_E_NULL);
    TS_NAME(TS_E_STRUCT_SIZE);
    TS_NAME(TS_E_BUFFER_TOO_SMALL);
    TS_NAME(TS_E_NOT_FOUND);
    TS_NAME(TS_E_MISMATCH);
    TS_NAME(TS_E_OUT_OF_MEMORY);
    TS_NAME(TS_E_CANCELLED);
    TS_NAME(TS_E_INTERNAL);
    TS_NAME(TS_E_FILE_OPEN);
    TS_NAME(TS_E_FILE_FORMAT);
    TS_NAME(TS_E_FILE_TRUNCATED);
    TS_NAME(TS_E_FILE_TRAILING);
    TS_NAME(TS_E_FILE_COUNT);
    TS_NAME(TS_E_FILE_SYNTAX);
    TS_NAME(TS_E_FILE_WRITE);
    TS_NAME(TS_E_FILE_NEWER);
    TS_NAME(TS_E_MESH_EMPTY);
    TS_NAME(TS_E_MESH_NON_FINITE);
    TS_NAME(TS_E_MESH_INDEX_RANGE);
    TS_NAME(TS_E_MESH_UNITS);
    TS_NAME(TS_E_MESH_TOO_LARGE);
    TS_NAME(TS_E_NO_TEETH);
    TS_NAME(TS_E_NO_CONSTRAINT);
    TS_NAME(TS_E_CLICK_OFF_SURFACE);
    TS_NAME(TS_E_CLICK_ON_GINGIVA);
    TS_NAME(TS_E_NO_CUT);
    TS_NAME(TS_E_SOLVER);
    TS_NAME(TS_E_LOCKED);
    TS_NAME(TS_E_NO_CHANGE);
    TS_NAME(TS_E_NO_HISTORY);
    TS_NAME(TS_E_TOO_MANY_TEETH);
    TS_NAME(TS_E_NUMBER_JAW);
    TS_NAME(TS_E_NUMBER_TAKEN);
    TS_NAME(TS_E_NUMBER_ORDER);
    TS_NAME(TS_E_EDIT_NOTHING);
    TS_NAME(TS_E_EDIT_ON_TOOTH);
    TS_NAME(TS_E_EDIT_CROSSING);
    TS_NAME(TS_E_EDIT_OFF_CUT);
    TS_NAME(TS_E_EDIT_NO_LOOP);
    TS_NAME(TS_E_NOT_CLOSED);
    case TS_STATUS_FORCE_INT: break;
  }
#undef TS_NAME
  return "TS_E_?";
}

#define TS_STRING2(x) #x
#define TS_STRING(x) TS_STRING2(x)

const char *ts_version(void) {
  return TS_STRING(TS_VERSION_MAJOR) "." TS_STRING(TS_VERSION_MINOR) "." TS_STRING(TS_VERSION_PATCH);
}
