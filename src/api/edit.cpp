#include "api/guard.h"
#include "api/segmentation_handle.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::mesh::Index;
using ts::mesh::Vec3;
using ts::tooth::CutEdit;
using ts::tooth::EditKind;
using ts::tooth::EditRecord;

namespace ts::api {
namespace {

static_assert(static_cast<uint32_t>(EditKind::drag) == TS_EDIT_DRAG);
static_assert(static_cast<uint32_t>(EditKind::draw) == TS_EDIT_DRAW);
static_assert(static_cast<uint32_t>(EditKind::offset) == TS_EDIT_OFFSET);
static_assert(static_cast<uint32_t>(EditKind::smooth) == TS_EDIT_SMOOTH);

// Calls work(surroundings) with what is around a tooth of a session.
template <class Work>
auto among_others(const Prepared &p, const tooth::Session &session, Index group, Work &&work) {
  Vec<const tooth::Tooth *> others;
  for (const Index g : session.teeth())
    if (g != group) others.push_back(session.tooth(g));
  const auto nearest = [&](const Vec3 &at) { return p.features->model->nearest(at); };
  return work(tooth::Surroundings{others, nearest});
}

// Applies an edit to a tooth as it is, and keeps it with those before.
void edit_tooth(ts_segmentation *segmentation, Index group, ts_job *job, CutEdit edit) {
  const Prepared &p = *segmentation->prepared;
  const ts::Progress progress = progress_of(job);
  tooth::Session next = segmentation->session;
  tooth::Tooth made = among_others(p, next, group, [&](const tooth::Surroundings &around) {
    return p.segmenter->edit(*next.tooth(group), edit, around, next.click(next.click_of(group)), next.among());
  });
  Vec<EditRecord> edits = next.edits(group);
  EditRecord record;
  record.edit = std::move(edit);
  edits.push_back(std::move(record));
  next.replace(group, std::move(made), std::move(edits));
  progress(1);
  segmentation->session = std::move(next);
}

Vec3 vector_of(const double *p) {
  return {p[0], p[1], p[2]};
}

}  // namespace

void add_click(const Prepared &p, tooth::Session &session, tooth::Click click) {
  Vec<std::pair<Index, Vec<EditRecord>>> edited;
  for (const tooth::Tooth &t : click.teeth)
    if (session.tooth(t.group) && !session.edits(t.group).empty()) edited.emplace_back(t.group, session.edits(t.group));
  session.add(std::move(click));
  for (auto &[group, edits] : edited) {
    tooth::Tooth made = among_others(p, session, group, [&, g = group, &e = edits](const tooth::Surroundings &around) {
      return p.segmenter->edit_again(*session.tooth(g), e, around, session.click(session.click_of(g)), session.among());
    });
    for (std::size_t i = 0; i < edits.size(); ++i)
      if (edits[i].dropped)
        p.context().write_log(TS_LOG_WARNING, "edit " + std::to_string(i) + " of the tooth with label " +
                                                  std::to_string(group + 1) + " was dropped: " + edits[i].why);
    session.replace(group, std::move(made), std::move(edits));
  }
}

}  // namespace ts::api

ts_status ts_cut_drag(ts_segmentation *segmentation, uint32_t tooth, uint32_t loop, uint32_t point, const double to[3],
                      double reach, ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    need(to, "to");
    need_finite(to, "to");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    const auto &loops = segmentation->session.tooth(group)->loops;
    if (loop >= loops.size() || point >= loops[loop].line.points.size())
      throw Error(Fault::not_found, "tooth " + std::to_string(tooth) + " has no point " + std::to_string(point) +
                                        " in loop " + std::to_string(loop));
    edit_tooth(segmentation, group, job,
               {EditKind::drag, {loops[loop].line.points[point].position, vector_of(to)}, reach});
  });
}

ts_status ts_cut_draw(ts_segmentation *segmentation, uint32_t tooth, const double *points, uint32_t count,
                      ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    need(points, "points");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    CutEdit edit{EditKind::draw, {}, 0};
    for (std::size_t i = 0; i < count; ++i) {
      need_finite(points + 3 * i, "a point");
      edit.points.push_back(vector_of(points + 3 * i));
    }
    edit_tooth(segmentation, group, job, std::move(edit));
  });
}

ts_status ts_cut_offset(ts_segmentation *segmentation, uint32_t tooth, double mm, ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    edit_tooth(segmentation, group, job, {EditKind::offset, {}, mm});
  });
}

ts_status ts_cut_smooth(ts_segmentation *segmentation, uint32_t tooth, double strength, ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    edit_tooth(segmentation, group, job, {EditKind::smooth, {}, strength});
  });
}

ts_status ts_cut_reset(ts_segmentation *segmentation, uint32_t tooth) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    ts::tooth::Session next = segmentation->session;
    next.replace(group, {}, {});
    segmentation->session = std::move(next);
  });
}

ts_status ts_get_cut_edits(const ts_segmentation *segmentation, uint32_t tooth, ts_cut_edit *edits, uint32_t capacity,
                           uint32_t *count) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    copy_out(segmentation->session.edits(group), 1, edits, capacity, count, [](const EditRecord &r, ts_cut_edit *to) {
      ts_cut_edit e{};
      e.kind = static_cast<ts_edit_kind>(r.edit.kind);
      e.status = r.dropped ? status_of(r.fault) : TS_OK;
      e.points = static_cast<uint32_t>(r.edit.points.size());
      e.amount = r.edit.amount;
      if (!r.edit.points.empty()) {
        std::copy_n(r.edit.points.front().data(), 3, e.from);
        std::copy_n(r.edit.points.back().data(), 3, e.to);
      }
      *to = e;
    });
  });
}
