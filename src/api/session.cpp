#include <algorithm>

#include "api/guard.h"
#include "api/segmentation_handle.h"
#include "tooth/prepared.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::mesh::Index;
using ts::mesh::Vec3;
using Act = Command::Act;

namespace ts::api {
namespace {

// To `there`, by `move`. What was worked out of clicks is that of others from then on.
template <class Move>
void travel(ts_segmentation *s, const tooth::Session &there, const Move &move) {
  need_quiet(*s);
  const AllocatorScope scope(s->prepared->context().allocator);
  Vec<uint32_t> ids;
  for (const Index g : tooth::Session::changed(s->session, there)) ids.push_back(id_of(*s, g));
  move();
  s->changes = std::move(ids);
  s->views.forget();
  s->details.forget();
  tell(*s);
}

// Under this a tooth wants a look: above it the confidence can be relied on (docs/accuracy.md).
constexpr double kSure = 0.9;

// What a person should look at first: nothing there at all, then the least sure.
Vec<ts_review_item> review(const ts_segmentation &s) {
  Vec<ts_review_item> items;
  const auto &groups = s.prepared->features->set.groups();
  const tooth::Prepared &p = s.prepared->segmenter->prepared(s.session.among());
  for (const Index g : p.live) {
    const tooth::Tooth *t = s.session.tooth(g);
    ts_review_item item{};
    item.tooth = id_of(s, g);
    item.separated = t != nullptr;
    item.confidence = t ? t->confidence : 0;
    item.warnings = t ? t->warnings : 0;
    item.group_confidence = g < groups.size() ? groups[g].confidence : 1;
    if (!t || t->confidence < kSure || t->warnings) items.push_back(item);
  }
  std::ranges::stable_sort(
      items, [](const ts_review_item &a, const ts_review_item &b) { return a.confidence < b.confidence; });
  return items;
}

}  // namespace
}  // namespace ts::api

ts_status ts_segment_all(ts_segmentation *segmentation, ts_job *job) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    change(*segmentation, {Act::all}, progress_of(job));
  });
}

ts_status ts_get_review(const ts_segmentation *segmentation, ts_review_item *items, uint32_t capacity,
                        uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    copy_out(review(*segmentation), items, capacity, count);
  });
}

ts_status ts_tooth_include(ts_segmentation *segmentation, uint32_t tooth, const double position[3], ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    change(*segmentation, {Act::take_in, group, ts::mesh::none, {point_of(position, "position")}}, progress_of(job));
  });
}

ts_status ts_tooth_exclude(ts_segmentation *segmentation, uint32_t tooth, const double position[3], ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    change(*segmentation, {Act::leave_out, group, ts::mesh::none, {point_of(position, "position")}}, progress_of(job));
  });
}

ts_status ts_tooth_split(ts_segmentation *segmentation, uint32_t tooth, const double keep[3], const double part[3],
                         ts_job *job, uint32_t *second) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const Vec3 kept = point_of(keep, "keep"), other = point_of(part, "part");
    const Index made = segmentation->prepared->segmenter->prepared(segmentation->session.among()).groups;
    change(*segmentation, {Act::divide, group, ts::mesh::none, {kept, other}}, progress_of(job));
    if (second) *second = id_of(*segmentation, made);
  });
}

ts_status ts_tooth_move_point(ts_segmentation *segmentation, uint32_t tooth, const double from[3], const double to[3],
                              ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const Vec3 old = point_of(from, "from"), other = point_of(to, "to");
    change(*segmentation, {Act::move, group, ts::mesh::none, {old, other}}, progress_of(job));
  });
}

ts_status ts_tooth_merge(ts_segmentation *segmentation, uint32_t tooth, uint32_t other, ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    change(*segmentation, {Act::unite, group, group_of(segmentation, other), {}}, progress_of(job));
  });
}

ts_status ts_tooth_remove(ts_segmentation *segmentation, uint32_t tooth) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    change(*segmentation, {Act::remove, group});
  });
}

ts_status ts_tooth_set_locked(ts_segmentation *segmentation, uint32_t tooth, uint32_t locked) {
  return guarded(__func__, [&] {
    if (locked > 1) throw Error(Fault::invalid_argument, "locked is " + std::to_string(locked) + ", not 0 or 1");
    const Index group = group_of(segmentation, tooth);
    change(*segmentation, {locked ? Act::lock : Act::unlock, group});
  });
}

ts_status ts_tooth_get_locked(const ts_segmentation *segmentation, uint32_t tooth, uint32_t *locked) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    need(locked, "locked");
    *locked = segmentation->session.locked(group);
  });
}

ts_status ts_get_overlaps(const ts_segmentation *segmentation, ts_overlap *overlaps, uint32_t capacity,
                          uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    copy_out(segmentation->session.overlaps(), 1, overlaps, capacity, count,
             [&](const ts::tooth::Overlap &o, ts_overlap *to) {
               *to = {id_of(*segmentation, o.winner), id_of(*segmentation, o.loser), o.faces, 0, o.area};
             });
  });
}

ts_status ts_undo(ts_segmentation *segmentation) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    ts_segmentation &s = *segmentation;
    travel(&s, s.history.before(), [&] { s.history.undo(s.session); });
  });
}

ts_status ts_redo(ts_segmentation *segmentation) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    ts_segmentation &s = *segmentation;
    travel(&s, s.history.after(), [&] { s.history.redo(s.session); });
  });
}

ts_status ts_get_history(const ts_segmentation *segmentation, ts_history_info *info) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(info, "info");
    const History &h = segmentation->history;
    write_struct(info,
                 ts_history_info{0, static_cast<uint32_t>(h.done().size()), static_cast<uint32_t>(h.undone().size()),
                                 h.forgotten().empty(), h.bytes(), h.limit()},
                 info->struct_size, "ts_history_info");
  });
}

ts_status ts_set_history_limit(ts_segmentation *segmentation, uint64_t bytes) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    segmentation->history.set_limit(static_cast<std::size_t>(std::min<uint64_t>(bytes, SIZE_MAX)));
  });
}

ts_status ts_get_changes(const ts_segmentation *segmentation, uint32_t *teeth, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    copy_out(segmentation->changes, teeth, capacity, count);
  });
}

ts_status ts_set_change_callback(ts_segmentation *segmentation, ts_change_fn callback, void *user) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    segmentation->listener = {callback, user};
  });
}
