#include "api/guard.h"
#include "api/segmentation_handle.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::mesh::Index;
using ts::tooth::Click;
using ts::tooth::ClickView;
using ts::tooth::Cut;
using ts::tooth::Tooth;

namespace ts::api {
namespace {

static_assert(static_cast<uint32_t>(tooth::Warning::area_small) == TS_WARN_AREA_SMALL);
static_assert(static_cast<uint32_t>(tooth::Warning::area_large) == TS_WARN_AREA_LARGE);
static_assert(static_cast<uint32_t>(tooth::Warning::open_at_border) == TS_WARN_OPEN_AT_BORDER);
static_assert(static_cast<uint32_t>(tooth::Warning::several_loops) == TS_WARN_SEVERAL_LOOPS);
static_assert(static_cast<uint32_t>(tooth::Warning::no_neighbour) == TS_WARN_NO_NEIGHBOUR);
static_assert(static_cast<uint32_t>(tooth::Warning::seed_rejected) == TS_WARN_SEED_REJECTED);
static_assert(static_cast<uint32_t>(tooth::Warning::width) == TS_WARN_WIDTH);
static_assert(static_cast<uint32_t>(tooth::Warning::two_groups) == TS_WARN_TWO_GROUPS);
static_assert(static_cast<uint32_t>(tooth::Warning::flat_top) == TS_WARN_FLAT_TOP);
static_assert(static_cast<uint32_t>(tooth::Warning::made_by_click) == TS_WARN_MADE_BY_CLICK);

const Click &find_click(const ts_segmentation *s, uint32_t click) {
  need(s, "segmentation");
  if (click >= s->session.clicks())
    throw Error(Fault::not_found,
                "no click " + std::to_string(click) + ", there are " + std::to_string(s->session.clicks()));
  return s->session.click(click);
}

// Of the first group that a click makes; the others follow.
uint32_t first_made_id(const ts_segmentation &s) {
  uint32_t id = 0;
  for (const auto &g : s.prepared->features->set.groups()) id = std::max(id, g.id + 1);
  return id;
}

// Groups have ids for the caller, which differ from their places along the arch once groups have been edited.
uint32_t id_of(const ts_segmentation &s, Index group) {
  const auto &groups = s.prepared->features->set.groups();
  if (group == mesh::none) return TS_NONE;
  return group < groups.size() ? groups[group].id : first_made_id(s) + static_cast<uint32_t>(group - groups.size());
}

Index group_of(const ts_segmentation *s, uint32_t id) {
  need(s, "segmentation");
  const auto &groups = s->prepared->features->set.groups();
  const auto it = std::ranges::find(groups, id, &features::FeatureSet::Group::id);
  Index group = static_cast<Index>(it - groups.begin());
  if (it == groups.end() && id >= first_made_id(*s)) group += id - first_made_id(*s);
  if ((it == groups.end() && id < first_made_id(*s)) || !s->session.tooth(group))
    throw Error(Fault::not_found, "no tooth " + std::to_string(id) + " has been separated");
  return group;
}

}  // namespace

const Tooth &find_tooth(const ts_segmentation *s, uint32_t id) {
  const Index group = group_of(s, id);  // looks first whether there is an s
  return *s->session.tooth(group);
}

namespace {

std::shared_ptr<const ClickView> view_of(const ts_segmentation *s, uint32_t click) {
  const Click &c = find_click(s, click);
  const AllocatorScope scope(s->prepared->context().allocator);
  return s->views.get(click, [&] { return s->prepared->segmenter->view(c); });
}

void write_point(const cut::EdgePoint &p, ts_edge_point *to) {
  *to = {p.a, p.b, p.t, {p.position[0], p.position[1], p.position[2]}};
}

}  // namespace
}  // namespace ts::api

ts_status ts_get_click_count(const ts_segmentation *segmentation, uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(count, "count");
    *count = segmentation->session.clicks();
  });
}

ts_status ts_get_click(const ts_segmentation *segmentation, uint32_t click, ts_click_info *info) {
  return guarded(__func__, [&] {
    const Click &c = find_click(segmentation, click);
    need(info, "info");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    const ts::tooth::ClickDetails d =
        segmentation->details.get(click, [&] { return segmentation->prepared->segmenter->details(c); });
    ts_click_info i{};
    i.target = id_of(*segmentation, c.target);
    i.neighbour = id_of(*segmentation, c.neighbour);
    std::copy_n(c.at.position.data(), 3, i.position);
    i.target_distance = c.target_distance;
    i.neighbour_distance = d.neighbour_distance;
    i.v_med = d.v_med;
    i.target_iso = c.target_iso;
    i.neighbour_iso = c.neighbour_iso;
    i.ms = {c.ms.pick, c.ms.field, c.ms.cut, c.ms.label, c.ms.total};
    write_struct(info, i, info->struct_size, "ts_click_info");
  });
}

ts_status ts_get_field(const ts_segmentation *segmentation, uint32_t click, double *u, uint32_t capacity,
                       uint32_t *count) {
  return guarded(__func__, [&] {
    const std::shared_ptr<const ClickView> view = view_of(segmentation, click);
    copy_out(view->u, u, capacity, count);
  });
}

ts_status ts_get_histogram(const ts_segmentation *segmentation, uint32_t click, uint32_t *bins, uint32_t capacity,
                           uint32_t *count) {
  return guarded(__func__, [&] {
    const std::shared_ptr<const ClickView> view = view_of(segmentation, click);
    copy_out(view->histogram, bins, capacity, count);
  });
}

ts_status ts_get_contours(const ts_segmentation *segmentation, uint32_t click, ts_contour_info *contours,
                          uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    const std::shared_ptr<const ClickView> view = view_of(segmentation, click);
    copy_out(view->contours, 1, contours, capacity, count, [](const ts::tooth::Contour &c, ts_contour_info *to) {
      uint32_t points = 0;
      for (const auto &line : c.lines) points += static_cast<uint32_t>(line.points.size());
      *to = {c.iso, c.gradient, c.concavity, c.length, points, static_cast<uint32_t>(c.lines.size()), c.chosen};
    });
  });
}

ts_status ts_get_contour_points(const ts_segmentation *segmentation, uint32_t click, uint32_t contour,
                                ts_edge_point *points, uint32_t capacity, uint32_t *count, uint32_t *starts,
                                uint8_t *closed) {
  return guarded(__func__, [&] {
    const std::shared_ptr<const ClickView> view = view_of(segmentation, click);
    if (contour >= view->contours.size())
      throw Error(Fault::not_found,
                  "no contour " + std::to_string(contour) + ", there are " + std::to_string(view->contours.size()));
    ts::Vec<ts::cut::EdgePoint> all;
    ts::Vec<uint32_t> first;
    for (const auto &line : view->contours[contour].lines) {
      first.push_back(static_cast<uint32_t>(all.size()));
      all.insert(all.end(), line.points.begin(), line.points.end());
    }
    copy_out(all, 1, points, capacity, count, write_point);
    if (starts) std::copy(first.begin(), first.end(), starts);
    if (closed)
      for (const auto &line : view->contours[contour].lines) *closed++ = line.closed;
  });
}

ts_status ts_get_teeth(const ts_segmentation *segmentation, uint32_t *teeth, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    copy_out(segmentation->session.teeth(), 1, teeth, capacity, count,
             [&](Index group, uint32_t *to) { *to = id_of(*segmentation, group); });
  });
}

ts_status ts_get_tooth(const ts_segmentation *segmentation, uint32_t tooth, ts_tooth_info *info) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const Tooth &t = *segmentation->session.tooth(group);
    need(info, "info");
    ts_tooth_info i{};
    i.id = tooth;
    i.label = group + 1;
    i.click = segmentation->session.click_of(group);
    i.faces = static_cast<uint32_t>(t.faces.size());
    i.vertices = static_cast<uint32_t>(t.vertices.size());
    i.loops = static_cast<uint32_t>(t.loops.size());
    i.seeds = static_cast<uint32_t>(t.seeds.size());
    i.area = t.area;
    i.iso = t.iso;
    i.gradient = t.gradient;
    i.confidence = t.confidence;
    i.warnings = t.warnings;
    write_struct(info, i, info->struct_size, "ts_tooth_info");
  });
}

ts_status ts_get_tooth_faces(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *faces, uint32_t capacity,
                             uint32_t *count) {
  return guarded(__func__, [&] { copy_out(find_tooth(segmentation, tooth).faces, faces, capacity, count); });
}

ts_status ts_get_tooth_vertices(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *vertices,
                                uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] { copy_out(find_tooth(segmentation, tooth).vertices, vertices, capacity, count); });
}

ts_status ts_get_tooth_seeds(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *vertices, uint32_t capacity,
                             uint32_t *count) {
  return guarded(__func__, [&] { copy_out(find_tooth(segmentation, tooth).seeds, vertices, capacity, count); });
}

ts_status ts_get_cut(const ts_segmentation *segmentation, uint32_t tooth, uint32_t loop, ts_cut_info *info,
                     ts_edge_point *points, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    const Tooth &t = find_tooth(segmentation, tooth);
    if (loop >= t.loops.size())
      throw Error(Fault::not_found, "tooth " + std::to_string(tooth) + " has no loop " + std::to_string(loop) +
                                        ", it has " + std::to_string(t.loops.size()));
    const Cut &c = t.loops[loop];
    if (info) check_size<ts_cut_info>(info->struct_size, "ts_cut_info");
    if (points || count || !info) copy_out(c.line.points, 1, points, capacity, count, write_point);
    if (info)
      write_struct(info,
                   ts_cut_info{0, static_cast<uint32_t>(c.line.points.size()), c.line.closed, c.line.length, c.iso,
                               c.gradient, c.concavity},
                   info->struct_size, "ts_cut_info");
  });
}

ts_status ts_get_labels(const ts_segmentation *segmentation, uint32_t *labels, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    const ts::Vec<uint32_t> of_face = segmentation->session.labels();
    copy_out(segmentation->prepared->features->model->model.label_source, 1, labels, capacity, count,
             [&](Index face, uint32_t *to) { *to = face == ts::mesh::none ? 0 : of_face[face]; });
  });
}
