// The exceptions of the library: one class, one reason each. The api room turns a reason into the ts_status of the same
// name; nothing else is thrown on purpose.
#pragma once

#include <stdexcept>
#include <string>

namespace ts {

enum class Fault {
  invalid_argument,
  null,
  struct_size,
  buffer_too_small,
  not_found,
  mismatch,
  out_of_memory,
  cancelled,
  internal,
  file_open,
  file_format,
  file_truncated,
  file_trailing,
  file_count,
  file_syntax,
  file_write,
  file_newer,
  mesh_empty,
  mesh_non_finite,
  mesh_index_range,
  mesh_units,
  mesh_too_large,
  no_teeth,
  no_constraint,
  click_off_surface,
  click_on_gingiva,
  no_cut,
  solver,
  locked,
  no_change,
  no_history,
  too_many_teeth,
  number_jaw,
  number_taken,
  number_order,
  edit_nothing,
  edit_on_tooth,
  edit_crossing,
  edit_off_cut,
  edit_no_loop,
  not_closed,
};

class Error : public std::runtime_error {
 public:
  Error(Fault fault, const std::string &what) : std::runtime_error(what), fault_(fault) {}
  Fault fault() const noexcept { return fault_; }

 private:
  Fault fault_;
};

}  // namespace ts
