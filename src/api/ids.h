// Ids of the caller's for places along the arch: these differ once feature groups have been edited.
#pragma once

#include <algorithm>

#include "api/segmentation_handle.h"

namespace ts::api {

// Of the first group that a click makes; the others follow.
inline uint32_t first_made_id(const ts_segmentation &s) {
  uint32_t id = 0;
  for (const auto &g : s.prepared->features->set.groups()) id = std::max(id, g.id + 1);
  return id;
}

inline uint32_t id_of(const ts_segmentation &s, mesh::Index group) {
  const auto &groups = s.prepared->features->set.groups();
  if (group == mesh::none) return TS_NONE;
  return group < groups.size() ? groups[group].id : first_made_id(s) + static_cast<uint32_t>(group - groups.size());
}

}  // namespace ts::api
