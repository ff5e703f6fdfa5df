#include "api/guard.h"
#include "api/segmentation_handle.h"

namespace ts::api {
namespace {

// Of the first group that a click makes; the others follow.
uint32_t first_made_id(const ts_segmentation &s) {
  uint32_t id = 0;
  for (const auto &g : s.prepared->features->set.groups()) id = std::max(id, g.id + 1);
  return id;
}

}  // namespace

// Groups have ids for the caller, which differ from their places along the arch once groups have been edited.
uint32_t id_of(const ts_segmentation &s, mesh::Index group) {
  const auto &groups = s.prepared->features->set.groups();
  if (group == mesh::none) return TS_NONE;
  return group < groups.size() ? groups[group].id : first_made_id(s) + static_cast<uint32_t>(group - groups.size());
}

mesh::Index group_of(const ts_segmentation *s, uint32_t id) {
  need(s, "segmentation");
  const auto &groups = s->prepared->features->set.groups();
  const auto it = std::ranges::find(groups, id, &features::FeatureSet::Group::id);
  mesh::Index group = static_cast<mesh::Index>(it - groups.begin());
  if (it == groups.end() && id >= first_made_id(*s)) group += id - first_made_id(*s);
  if ((it == groups.end() && id < first_made_id(*s)) || !s->session.tooth(group))
    throw Error(Fault::not_found, "no tooth " + std::to_string(id) + " has been separated");
  return group;
}

const tooth::Tooth &find_tooth(const ts_segmentation *s, uint32_t id) {
  const mesh::Index group = group_of(s, id);  // looks first whether there is an s
  return *s->session.tooth(group);
}

}  // namespace ts::api
