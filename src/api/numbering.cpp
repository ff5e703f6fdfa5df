#include "api/guard.h"
#include "api/segmentation_handle.h"
#include "tooth/prepared.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;
using ts::features::Jaw;
using ts::mesh::Index;
using ts::tooth::NumberOptions;
using ts::tooth::Numbers;

namespace ts::api {
namespace {

ts_jaw public_jaw(Jaw jaw) {
  return jaw == Jaw::upper ? TS_JAW_UPPER : TS_JAW_LOWER;
}

ts_number_options public_number_options(const NumberOptions &o) {
  ts_number_options p{};
  p.struct_size = sizeof p;
  p.jaw = o.jaw ? public_jaw(*o.jaw) : TS_JAW_UNKNOWN;
  p.mirrored = o.mirrored;
  p.least_confidence = o.least_confidence;
  return p;
}

NumberOptions inner_number_options(const ts_number_options &o) {
  NumberOptions n;
  need_value(o.jaw, TS_JAW_LOWER, "jaw");
  if (o.mirrored > 1) throw Error(Fault::invalid_argument, "mirrored is " + std::to_string(o.mirrored));
  if (!(o.least_confidence >= 0 && o.least_confidence <= 1))
    throw Error(Fault::invalid_argument, "least_confidence is not between 0 and 1");
  if (o.jaw != TS_JAW_UNKNOWN) n.jaw = o.jaw == TS_JAW_UPPER ? Jaw::upper : Jaw::lower;
  n.mirrored = o.mirrored != 0;
  n.least_confidence = o.least_confidence;
  return n;
}

// The teeth along the arch: groups of the features that have a point in use, and those that clicks made.
struct Row {
  ts::Vec<Index> groups;
  tooth::ArchRow measured;
};

ts::Vec<Index> groups_along(const Prepared &p, const tooth::Session &session) {
  if (session.among()) return session.among()->live;
  ts::Vec<Index> all;
  const tooth::Segmenter &segmenter = *p.segmenter;
  const auto &groups = p.features->set.groups();
  for (Index g = 0; g < segmenter.groups(); ++g)
    if (segmenter.rejected_points(g).size() < groups[g].points) all.push_back(g);
  return all;
}

Row row_of(const Prepared &p, const tooth::Session &session) {
  const features::Features found = p.features->set.features();
  Row row;
  ts::Vec<tooth::RowTooth> teeth;
  for (const Index g : groups_along(p, session)) {
    const tooth::RowTooth t{g < found.groups.size() ? &found.groups[g] : nullptr, session.tooth(g)};
    if (!t.group && !t.tooth) continue;
    row.groups.push_back(g);
    teeth.push_back(t);
  }
  row.measured = tooth::arch_row(p.surface(), found, teeth);
  return row;
}

}  // namespace

Numbers numbers_after(const Prepared &p, const tooth::Session &session, const Command &command) {
  const Row row = row_of(p, session);
  Numbers next = session.numbers();
  if (command.act == Command::Act::assign_numbers) {
    next.assign(row.measured, row.groups, command.numbering);
    return next;
  }
  if (std::ranges::find(row.groups, command.tooth) == row.groups.end())
    throw Error(Fault::not_found, "no such tooth along the arch");
  if (command.number == 0)
    next.forget(row.measured, row.groups, command.tooth);
  else
    next.set(row.measured, row.groups, command.tooth, command.number);
  return next;
}

}  // namespace ts::api

ts_status ts_number_options_init(ts_number_options *options, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(options, "options");
    write_struct(options, public_number_options({}), struct_size, "ts_number_options");
  });
}

ts_status ts_assign_numbers(ts_segmentation *segmentation, const ts_number_options *options) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    Command command;
    command.act = Command::Act::assign_numbers;
    command.numbering = inner_number_options(read_options(options, public_number_options({}), "ts_number_options"));
    change(*segmentation, std::move(command));
  });
}

ts_status ts_set_number(ts_segmentation *segmentation, uint32_t tooth, uint32_t fdi) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const auto &live = segmentation->prepared->segmenter->prepared(segmentation->session.among()).live;
    const auto group = std::ranges::find_if(live, [&](Index g) { return id_of(*segmentation, g) == tooth; });
    if (group == live.end()) throw Error(Fault::not_found, "no tooth " + std::to_string(tooth) + " along the arch");
    Command command;
    command.act = Command::Act::set_number;
    command.tooth = *group;
    command.number = fdi;
    change(*segmentation, std::move(command));
  });
}

ts_status ts_get_number(const ts_segmentation *segmentation, uint32_t tooth, ts_number_info *info) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(info, "info");
    const Numbers &numbers = segmentation->session.numbers();
    for (const Numbers::Number &n : numbers.numbers())
      if (id_of(*segmentation, n.group) == tooth) {
        ts_number_info i{};
        i.fdi = n.fdi;
        i.set_by_hand = n.by_hand;
        i.uncertain = numbers.uncertain(n.confidence);
        i.confidence = n.confidence;
        return write_struct(info, i, info->struct_size, "ts_number_info");
      }
    throw Error(Fault::not_found, "tooth " + std::to_string(tooth) + " has no number: ts_assign_numbers gives them");
  });
}

ts_status ts_get_jaw(const ts_segmentation *segmentation, ts_jaw_info *info) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(info, "info");
    const Numbers &numbers = segmentation->session.numbers();
    if (!numbers.assigned()) throw Error(Fault::not_found, "no numbers: ts_assign_numbers gives them");
    ts_jaw_info i{};
    i.jaw = public_jaw(numbers.jaw().jaw);
    i.given = numbers.jaw().given;
    i.uncertain = numbers.uncertain(numbers.jaw().confidence);
    i.confidence = numbers.jaw().confidence;
    write_struct(info, i, info->struct_size, "ts_jaw_info");
  });
}

ts_status ts_fdi_to_universal(uint32_t fdi, uint32_t *universal) {
  return guarded(__func__, [&] {
    need(universal, "universal");
    *universal = ts::tooth::universal_of(fdi);
  });
}

ts_status ts_universal_to_fdi(uint32_t universal, uint32_t *fdi) {
  return guarded(__func__, [&] {
    need(fdi, "fdi");
    *fdi = ts::tooth::fdi_of_universal(universal);
  });
}

ts_status ts_fdi_to_palmer(uint32_t fdi, ts_palmer *palmer) {
  return guarded(__func__, [&] {
    need(palmer, "palmer");
    const ts::tooth::Palmer p = ts::tooth::palmer_of(fdi);
    ts_palmer out{};
    out.quadrant = p.quadrant;
    out.position = p.position;
    p.letters.copy(out.letters, sizeof out.letters - 1);
    p.symbol.copy(out.symbol, sizeof out.symbol - 1);
    write_struct(palmer, out, palmer->struct_size, "ts_palmer");
  });
}
