// What has to hold of every result of the library, whatever went in. Ends the program where it does not.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toothseg.h>

#include <cstdint>
#include <initializer_list>
#include <vector>

namespace check {

// Ends the program with what did not hold.
[[noreturn]] void fail(const char *what, const char *file, int line);
#define HOLDS(condition) ((condition) ? void() : ::check::fail(#condition, __FILE__, __LINE__))

// The status is a known one and of one of these blocks (its hundreds), or TS_OK; a failure has a message.
void status(ts_status got, std::initializer_list<int> blocks);

// All that a getter of the two-call idiom gives; `call` as get(buffer, capacity, &count), `width` values an element.
template <class T, class Call>
std::vector<T> all(const Call &call, std::size_t width = 1) {
  std::uint32_t count = 0, again = 0;
  HOLDS(call(nullptr, 0, &count) == TS_OK);
  std::vector<T> items(width * std::size_t{count});
  HOLDS(call(items.data(), count, &again) == TS_OK);
  HOLDS(again == count);
  return items;
}

void model(const ts_model *model);
// What intake reported is true of the model, and adds up; `model` has it in it.
void report(const ts_model *model);
void features(const ts_model *model, const ts_features *features);
// `deep`: also fields, histograms and contours of the clicks, and the meshes of the teeth and of the gingiva; that one
// closed as well unless `but_closed_gingiva`: it takes as long as all else.
void segmentation(const ts_model *model, const ts_segmentation *segmentation, bool deep,
                  bool but_closed_gingiva = false);
// A mesh of a tooth or of the gingiva.
void mesh(const ts_mesh *mesh);

}  // namespace check
