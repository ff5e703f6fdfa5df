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

// A step that edits a cut.
void edit_tooth(ts_segmentation *s, Index group, ts_job *job, CutEdit edit) {
  Command command;
  command.act = Command::Act::edit;
  command.tooth = group;
  command.edit = std::move(edit);
  change(*s, std::move(command), progress_of(job));
}

}  // namespace

void edit(const Prepared &p, tooth::Session &next, const Command &command, const Progress &progress) {
  const Index group = command.tooth;
  if (!next.tooth(group)) throw Error(Fault::not_found, "no such tooth has been separated");
  if (next.locked(group)) throw Error(Fault::locked, "the tooth is locked");
  if (command.act == Command::Act::reset) {
    next.replace(group, {}, {});
    return;
  }
  tooth::Tooth made = among_others(p, next, group, [&](const tooth::Surroundings &around) {
    return p.segmenter->edit(*next.tooth(group), command.edit, around, next.click(next.click_of(group)), next.among());
  });
  Vec<EditRecord> edits = next.edits(group);
  EditRecord record;
  record.edit = command.edit;
  edits.push_back(std::move(record));
  next.replace(group, std::move(made), std::move(edits));
  progress(1);
}

void edit_again(const Prepared &p, const tooth::Session &before, tooth::Session &next) {
  for (const Index group : before.teeth()) {
    if (before.edits(group).empty() || !next.tooth(group) || next.tooth(group) == before.tooth(group)) continue;
    Vec<EditRecord> edits = before.edits(group);
    tooth::Tooth made = among_others(p, next, group, [&](const tooth::Surroundings &around) {
      return p.segmenter->edit_again(*next.tooth(group), edits, around, next.click(next.click_of(group)), next.among());
    });
    for (std::size_t i = 0; i < edits.size(); ++i)
      if (edits[i].dropped)
        p.context().write_log(TS_LOG_WARNING, "edit " + std::to_string(i) + " of the tooth with label " +
                                                  std::to_string(group + 1) + " was dropped: " + edits[i].why);
    next.replace(group, std::move(made), std::move(edits));
  }
}

}  // namespace ts::api

ts_status ts_cut_drag(ts_segmentation *segmentation, uint32_t tooth, uint32_t loop, uint32_t point, const double to[3],
                      double reach, ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    const Vec3 goal = point_of(to, "to");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    const auto &loops = segmentation->session.tooth(group)->loops;
    if (loop >= loops.size() || point >= loops[loop].line.points.size())
      throw Error(Fault::not_found, "tooth " + std::to_string(tooth) + " has no point " + std::to_string(point) +
                                        " in loop " + std::to_string(loop));
    edit_tooth(segmentation, group, job, {EditKind::drag, {loops[loop].line.points[point].position, goal}, reach});
  });
}

ts_status ts_cut_draw(ts_segmentation *segmentation, uint32_t tooth, const double *points, uint32_t count,
                      ts_job *job) {
  return guarded(__func__, [&] {
    const Index group = group_of(segmentation, tooth);
    need(points, "points");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    CutEdit edit{EditKind::draw, {}, 0};
    for (std::size_t i = 0; i < count; ++i) edit.points.push_back(point_of(points + 3 * i, "a point"));
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
    if (segmentation->session.edits(group).empty()) return;  // it is so already, and no step
    Command command;
    command.act = Command::Act::reset;
    command.tooth = group;
    change(*segmentation, std::move(command));
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
