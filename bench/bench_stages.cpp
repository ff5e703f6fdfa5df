#include <algorithm>
#include <optional>
#include <stdexcept>
#include <thread>

#include "api/segmentation_handle.h"
#include "bench/bench_compare.h"
#include "bench/bench_pipeline.h"
#include "bench/bench_solver.h"

namespace ts::bench {
namespace {

struct Clicks {
  Samples whole, pick, field, cut, label, labels, field_bytes;
  unsigned failed = 0;
};

// Clicks one after the other; a click and the labels of all faces after it are timed as one, and the labels once more.
void click_each(Pipeline &p, const std::vector<Point> &points, std::vector<uint32_t> &labels, Clicks &clicks) {
  ts_segmentation *const s = p.segmentation.get();
  for (const Point &at : points) {
    uint32_t click = 0, count = 0;
    ts_status status = TS_OK;
    const double whole = ms_of([&] {
      status = ts_segment_click(s, at.data(), nullptr, &click);
      if (status == TS_OK)
        need_ok(ts_get_labels(s, labels.data(), static_cast<uint32_t>(labels.size()), &count), "ts_get_labels");
    });
    if (status != TS_OK) {
      ++clicks.failed;
      continue;
    }
    clicks.whole.add(whole);
    // Not by ts_get_click, which works out what the click did not need.
    const tooth::Click &done = s->session.click(click);
    clicks.pick.add(done.ms.pick);
    clicks.field.add(done.ms.field);
    clicks.cut.add(done.ms.cut);
    clicks.label.add(done.ms.label);
    clicks.field_bytes.add(static_cast<double>(done.field_bytes));
    clicks.labels.add(ms_of([&] {
      need_ok(ts_get_labels(s, labels.data(), static_cast<uint32_t>(labels.size()), &count), "ts_get_labels");
    }));
  }
}

// A round: the clicks the library proposes on the untouched scan, then one at random on every tooth they separated.
void click_round(Pipeline &p, std::uint64_t seed, std::vector<uint32_t> &labels, Clicks &clicks) {
  forget_clicks(p);
  click_each(p, proposed_clicks(p), labels, clicks);
  const std::vector<Point> points = points_on_teeth(p, seed);
  forget_clicks(p);
  click_each(p, points, labels, clicks);
}

struct Stages {
  Samples load, intake, features, weights, factorise, basis, segmentation, prepare;

  void add(const Pipeline &p) {
    const ts_prepare_times times = prepare_times(p);
    intake.add(p.intake_ms);
    features.add(p.features_ms);
    segmentation.add(p.segmentation_ms);
    prepare.add(p.prepare_ms());
    weights.add(times.weights);
    factorise.add(times.factorise);
    if (const double ms = basis_ms(times); ms >= 0) basis.add(ms);
  }
};

double load_ms(const Pipeline &p, const std::vector<unsigned char> &stl) {
  ts_model *model = nullptr;
  const double ms = ms_of([&] {
    need_ok(ts_model_read(p.context.get(), stl.data(), stl.size(), TS_FORMAT_STL, nullptr, nullptr, &model),
            "ts_model_read");
  });
  ts_model_destroy(model);
  return ms;
}

// One thread and two in turns, each from the same prepared scan. `standard` has the default number of threads.
void measure_batches(const Mesh &mesh, Pipeline standard, const Effort &effort, Figures &figures) {
  Pipeline one = prepare(mesh, 1);
  Pipeline two = std::thread::hardware_concurrency() == 2 ? std::move(standard) : prepare(mesh, 2);
  const std::vector<Point> points = proposed_clicks(one);
  Samples times[2];
  const Timer timer;
  unsigned failed = 0;
  while (times[1].size() < effort.least || (times[1].size() < effort.most && timer.ms() < effort.batch_ms))
    for (Pipeline *p : {&one, &two}) {
      forget_clicks(*p);
      times[p == &two].add(ms_of([&] { failed = click_all(*p, points); }));
    }
  // The bound is that of one core: so is the field that it is compared with.
  Clicks alone;
  std::vector<uint32_t> labels(mesh.faces());
  for (int round = 1; round <= effort.rounds; ++round)
    click_round(one, static_cast<std::uint64_t>(round), labels, alone);
  figures.set("field_1t", alone.field.median());
  figures.set("click_1t", alone.whole.median());
  figures.set("batch_clicks", static_cast<double>(points.size()));
  figures.set("batch_failed", failed);
  figures.set("batch_1t", times[0].median());
  figures.set("batch_2t", times[1].median());
}

}  // namespace

void measure_times(const std::string &mesh_file, const RunOptions &options, Figures &figures) {
  const Mesh mesh = read_mesh(mesh_file);
  const Effort effort = effort_for(mesh.faces(), options.quick);
  const std::vector<unsigned char> stl = stl_of(mesh);
  figures.set("triangles", mesh.faces());
  figures.set("vertices", mesh.vertices());

  Stages stages;
  Clicks clicks;
  std::vector<uint32_t> labels(mesh.faces());
  std::optional<Comparison> comparison;
  Pipeline p;
  Timer timer;
  // Preparation, clicks and baselines in turns: what is divided by each other has seen the same machine.
  for (std::size_t turn = 0; turn < effort.least || (turn < effort.most && timer.ms() < effort.turns_ms); ++turn) {
    p = Pipeline();
    p = prepare(mesh, 0);
    stages.add(p);
    stages.load.add(load_ms(p, stl));
    if (turn == 0) {
      figures.set("groups", static_cast<double>(features_of(p).groups.size()));
      if (options.baselines) comparison.emplace(surface_of(p), features_of(p), effort, figures);
      if (effort.rounds > 1) {  // warms up
        click_round(p, 0, labels, clicks);
        clicks = {};
      }
      timer = Timer();
    }
    click_round(p, turn + 1, labels, clicks);
    if (comparison) comparison->turn();
    if (effort.rounds > 1) click_round(p, turn + 1001, labels, clicks);
  }
  figures.set("turns", static_cast<double>(stages.prepare.size()));
  figures.set("load", stages.load.median());
  figures.set("intake", stages.intake.median());
  figures.set("features", stages.features.median());
  figures.set("weights", stages.weights.median());
  figures.set("factorise", stages.factorise.median());
  figures.set("basis", stages.basis.median());
  figures.set("segmentation", stages.segmentation.median());
  figures.set("prepare", stages.prepare.median());
  figures.set("click", clicks.whole.median());
  figures.set("click_p95", clicks.whole.quantile(0.95));
  figures.set("clicks", static_cast<double>(clicks.whole.size()));
  figures.set("clicks_failed", clicks.failed);
  figures.set("pick", clicks.pick.median());
  figures.set("field", clicks.field.median());
  figures.set("cut", clicks.cut.median());
  figures.set("label", clicks.label.median());
  figures.set("labels", clicks.labels.median());
  figures.set("field_bytes", clicks.field_bytes.median());
  if (comparison) comparison->finish(effort, figures);
  comparison.reset();
  measure_batches(mesh, std::move(p), effort, figures);
}

}  // namespace ts::bench
