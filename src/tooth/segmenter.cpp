#include "tooth/segmenter.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "tooth/edit_cut.h"
#include "tooth/extract.h"
#include "tooth/propose.h"
#include "tooth/separate.h"

namespace ts::tooth {

struct Segmenter::Impl {
  Prepared prepared;
};

namespace {

// The groups that stand separated after a click.
void note(const Click &click, Vec<Index> &separated) {
  for (const Tooth &t : click.teeth) separated.push_back(t.group);
}

Click one_click(const Prepared &p, const Among &among, const mesh::SurfacePoint &at, std::span<const Index> separated,
                const Progress &progress) {
  Stopwatch watch;
  Pick picked = take(p, at);
  settle(picked, separated);
  const double pick_ms = watch.lap();
  bool evidence = false;
  Click click = separate(p, at, picked, pick_ms, progress, evidence);
  if (evidence)
    click = separate_by_evidence(p, at, separated, std::move(click), pick_ms + watch.lap(),
                                 progress.part(1, 1, "evidence"));
  if (!click.among) click.among = among;
  return click;
}

template <class Work>
void attempt(Segmenter::Outcome &outcome, Work &&work) {
  try {
    work();
  } catch (const Error &e) {
    if (e.fault() == Fault::cancelled) throw;
    outcome.click.reset();
    outcome.fault = e.fault();
    outcome.message = e.what();
  }
}

// What is measured on the field of the click that separated it.
void measure(const Prepared &p, const Click &of, Tooth &tooth) {
  Pick picked;
  picked.target = of.target;
  picked.neighbour = of.neighbour;
  Fields fields(p, picked, !own_field_decides(p.options));
  set_confidence(p, fields, tooth.group == of.target, tooth);
  measure_cuts(p, fields, tooth);
}

}  // namespace

Segmenter::Segmenter(const mesh::Surface &surface, const features::Features &features, const Options &options,
                     const Executor &executor, const Progress &progress)
    : impl_(std::make_unique<const Impl>(Impl{prepare(surface, features, options, executor, progress)})) {}
Segmenter::~Segmenter() = default;
Segmenter::Segmenter(Segmenter &&) noexcept = default;
Segmenter &Segmenter::operator=(Segmenter &&) noexcept = default;

Click Segmenter::click(const mesh::SurfacePoint &at, std::span<const Index> separated, const Progress &progress,
                       const Among &among) const {
  return one_click(prepared(among), among, at, separated, progress);
}

Vec<Segmenter::Outcome> Segmenter::clicks(std::span<const mesh::SurfacePoint> at, std::span<const Index> separated,
                                          const Progress &progress, const Among &among) const {
  const Prepared &p = prepared(among);
  struct Attempt {
    Pick faced, used;  // before and after what stands separated is looked at
    double ms = 0;
    bool taken = false;
    bool evidence = false;  // has to be looked at as such
  };
  Vec<Attempt> attempts(at.size());
  Vec<Outcome> outcomes(at.size());
  p.executor->each(at.size(), [&](std::size_t i) {
    Stopwatch watch;
    attempt(outcomes[i], [&] {
      attempts[i].faced = take(p, at[i]);
      attempts[i].taken = true;
    });
    attempts[i].ms = watch.lap();
  });
  const auto run = [&](std::size_t i) {
    attempt(outcomes[i], [&] {
      outcomes[i].click = separate(p, at[i], attempts[i].used, attempts[i].ms, {}, attempts[i].evidence);
      outcomes[i].click->among = among;
    });
  };
  // As if all clicks succeeded.
  Vec<Index> expected(separated.begin(), separated.end());
  for (Attempt &a : attempts) {
    if (!a.taken) continue;
    a.used = a.faced;
    settle(a.used, expected);
    expected.push_back(a.used.target);
    if (a.used.neighbour != mesh::none) expected.push_back(a.used.neighbour);
  }
  std::atomic<std::size_t> done{0};
  p.executor->each(at.size(), [&](std::size_t i) {
    if (attempts[i].taken) run(i);
    progress(static_cast<double>(++done) / static_cast<double>(at.size()));
  });
  // Where one did not, what came after it may have had another neighbour to take; where one made a group, all that came
  // after it did so among others.
  Vec<Index> actual(separated.begin(), separated.end());
  Among now = among;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (now != among || attempts[i].evidence) {
      attempt(outcomes[i], [&] {
        outcomes[i].click = one_click(now ? *now : p, now, at[i], actual, progress.part(1, 1, "evidence"));
      });
    } else if (attempts[i].taken) {
      Pick picked = attempts[i].faced;
      settle(picked, actual);
      if (picked.neighbour != attempts[i].used.neighbour) {
        attempts[i].used = picked;
        run(i);
      }
    }
    if (!outcomes[i].click) continue;
    note(*outcomes[i].click, actual);
    now = outcomes[i].click->among;
  }
  return outcomes;
}

Tooth Segmenter::edit(const Tooth &tooth, const CutEdit &edit, const Surroundings &around, const Click &of,
                      const Among &among) const {
  Tooth made = apply_edit(among ? *among : impl_->prepared, tooth, edit, around);
  measure(of.among ? *of.among : impl_->prepared, of, made);
  return made;
}

Tooth Segmenter::edit_again(const Tooth &automatic, std::span<EditRecord> edits, const Surroundings &around,
                            const Click &of, const Among &among) const {
  Tooth made = apply_edits(among ? *among : impl_->prepared, automatic, edits, around);
  measure(of.among ? *of.among : impl_->prepared, of, made);
  return made;
}

ClickDetails Segmenter::details(const Click &click) const {
  const Prepared &p = prepared(click.among);
  Pick picked;
  picked.target = click.target;
  picked.neighbour = click.neighbour;
  return {distance_to(p, click.at, click.neighbour),
          cut::histogram(Fields(p, picked, true).all_of_u(), p.options.histogram_bins).v_med};
}

ClickView Segmenter::view(const Click &click, const Progress &progress) const {
  const Prepared &p = prepared(click.among);
  progress(0);
  Pick picked;
  picked.target = click.target;
  picked.neighbour = click.neighbour;
  ClickView view;
  view.u = Fields(p, picked, true).all_of_u();
  view.histogram = cut::histogram(view.u, p.options.histogram_bins).bins;
  view.contours.resize(p.options.contours);
  const Vec<Vec<Index>> crossed = cut::crossed_faces(*p.surface, view.u, view.contours.size());
  p.executor->each(view.contours.size(), [&](std::size_t k) {
    Contour &c = view.contours[k];
    c.iso = cut::iso_value(k, view.contours.size());
    const auto u = [&](Index v) { return view.u[v]; };
    c.lines = cut::contour(*p.surface, u, c.iso, crossed[k]);
    const cut::Score s = cut::score(*p.surface, u, p.relief->concavity, c.lines);
    c.gradient = s.gradient;
    c.concavity = s.concavity;
    c.length = s.length;
  });
  // The sampled contour nearest to the iso-value of each cut.
  const auto mark = [&](double iso, unsigned which) {
    if (std::isnan(iso)) return;
    const auto nearest = std::min_element(
        view.contours.begin(), view.contours.end(),
        [&](const Contour &a, const Contour &b) { return std::abs(a.iso - iso) < std::abs(b.iso - iso); });
    nearest->chosen = which;
  };
  mark(click.target_iso, 1);
  mark(click.neighbour_iso, 2);
  progress(1);
  return view;
}

Vec<Vec3> Segmenter::propose_clicks(std::span<const Index> separated, const Among &among) const {
  return tooth::propose_clicks(prepared(among), separated);
}
const Prepared &Segmenter::prepared(const Among &among) const {
  return among ? *among : impl_->prepared;
}
const Options &Segmenter::options() const {
  return impl_->prepared.options;
}
const PrepareTimes &Segmenter::times() const {
  return impl_->prepared.times;
}
Memory Segmenter::memory() const {
  const Prepared &p = impl_->prepared;
  return {p.bytes() + p.solver->bytes(), p.solver->bytes(), p.solver->whole_bytes(),
          p.solver->solution_bytes() + cut::Space::bytes(*p.surface)};
}
Index Segmenter::groups() const {
  return impl_->prepared.groups;
}
const Vec<Index> &Segmenter::rejected_points(Index group) const {
  return impl_->prepared.rejected[group];
}

}  // namespace ts::tooth
