#include <algorithm>

#include "api/guard.h"
#include "api/segmentation_handle.h"
#include "base/shown.h"
#include "tooth/correct.h"

namespace ts::api {
namespace {

using mesh::Index;
using mesh::Vec3;
using tooth::Session;

mesh::SurfacePoint surface_point(const Prepared &p, const Vec3 &position) {
  return p.features->model->nearest(position);
}

// Near enough to the surface to be meant for it.
mesh::SurfacePoint point_on(const Prepared &p, const Vec3 &position) {
  mesh::SurfacePoint at = surface_point(p, position);
  if (at.distance > p.segmenter->options().click_reach)
    throw Error(Fault::click_off_surface, "the point is " + shown(at.distance) + " mm from the surface");
  return at;
}

// Clicks at once; of the command those stay that came to something.
void run_clicks(const Prepared &p, Session &next, Command &command, const Progress &progress,
                Vec<tooth::Segmenter::Outcome> *outcomes) {
  const std::size_t count = command.at.size();
  Vec<Vec3> good;
  constexpr std::size_t most = 256;  // at a time: a batch of any size takes the memory of these
  for (std::size_t first = 0; first < count; first += most) {
    const std::size_t end = std::min(count, first + most);
    Vec<mesh::SurfacePoint> at;
    for (std::size_t i = first; i < end; ++i) at.push_back(surface_point(p, command.at[i]));
    const auto share = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(count); };
    auto some = p.segmenter->clicks(at, next.teeth(), progress.part(share(first), share(end), "clicks"), next.among());
    for (std::size_t i = 0; i < some.size(); ++i) {
      if (some[i].click) next.add(*std::move(some[i].click)), good.push_back(command.at[first + i]);
      if (outcomes) outcomes->push_back(std::move(some[i]));
    }
  }
  command.at = std::move(good);
}

// Clicks of the library's own, until none is proposed that was not just made: a neighbour for which no cut was found
// gets one of its own, what came to nothing then is left.
void run_all(const Prepared &p, Session &next, const Progress &progress) {
  Command clicks;
  for (Vec<Vec3> last;;) {
    clicks.at = p.segmenter->propose_clicks(next.teeth(), next.among());
    if (clicks.at.empty() || clicks.at == last) return;
    last = clicks.at;
    run_clicks(p, next, clicks, progress, nullptr);
  }
}

}  // namespace

Session execute(const Prepared &p, const Session &session, Command &command, const Progress &progress,
                Vec<tooth::Segmenter::Outcome> *outcomes) {
  using Act = Command::Act;
  const StopScope stop(progress);  // ends before the caller is told what changed
  Session next = session;
  const ts::tooth::Prepared &groups = p.segmenter->prepared(session.among());
  const auto correct = [&](ts::tooth::Correction c) { next.apply(std::move(c), command.tooth); };
  const auto tooth = [&](Index group) {
    if (!session.tooth(group)) throw Error(Fault::not_found, "no such tooth has been separated");
    return group;
  };
  switch (command.act) {
    case Act::click: {
      ts::tooth::Click click =
          p.segmenter->click(surface_point(p, command.at.at(0)), next.teeth(), progress, next.among());
      if (next.locked(click.target)) throw Error(Fault::locked, "the tooth clicked is locked");
      next.add(std::move(click));
      break;
    }
    case Act::clicks: run_clicks(p, next, command, progress, outcomes); break;
    case Act::all: run_all(p, next, progress); break;
    case Act::take_in:
      correct(take_in(groups, session, tooth(command.tooth), point_on(p, command.at.at(0)), progress));
      break;
    case Act::leave_out:
      correct(leave_out(groups, session, tooth(command.tooth), point_on(p, command.at.at(0)), progress));
      break;
    case Act::divide:
      correct(divide(groups, session, tooth(command.tooth), point_on(p, command.at.at(0)),
                     point_on(p, command.at.at(1)), progress));
      break;
    case Act::move:
      correct(move_point(groups, session, tooth(command.tooth), point_on(p, command.at.at(0)),
                         point_on(p, command.at.at(1)), progress));
      break;
    case Act::unite: correct(unite(groups, session, tooth(command.tooth), tooth(command.other), progress)); break;
    case Act::remove: next.remove(command.tooth); break;
    case Act::lock: next.lock(command.tooth, true); break;
    case Act::unlock: next.lock(command.tooth, false); break;
    case Act::edit:
    case Act::reset: edit(p, next, command, progress); break;
    case Act::assign_numbers:
    case Act::set_number: next.set_numbers(numbers_after(p, session, command)); break;
  }
  if (command.act != Act::edit && command.act != Act::reset) edit_again(p, session, next);
  progress(1);
  return next;
}

void commit(ts_segmentation &s, Session next, Command command) {
  Vec<uint32_t> ids;
  for (const Index g : Session::changed(s.session, next)) ids.push_back(id_of(s, g));
  const std::size_t bytes = Session::added_bytes(s.session, next);
  Session before = s.session;
  s.history.record(std::move(before), std::move(command), bytes);
  s.session = std::move(next);
  s.changes = std::move(ids);
  tell(s);
}

void change(ts_segmentation &s, Command command, const Progress &progress) {
  need_quiet(s);
  const AllocatorScope scope(s.prepared->context().allocator);
  Session next = execute(*s.prepared, s.session, command, progress);
  commit(s, std::move(next), std::move(command));
}

void tell(ts_segmentation &s) {
  if (!s.listener.call || s.changes.empty()) return;
  s.telling = true;
  s.listener.call(s.listener.user, s.changes.data(), static_cast<uint32_t>(s.changes.size()));
  s.telling = false;
}

void need_quiet(const ts_segmentation &s) {
  if (s.telling) throw Error(Fault::invalid_argument, "the change callback must not change the segmentation");
}

}  // namespace ts::api
