// ts-click-times: how long one click takes on a mesh, stage by stage (paper, Fig. 11): the paper's way, which assembles
// and factorises for every click, and the library's. Medians over clicks, ms, as JSON.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "api/segmentation_handle.h"
#include "bench/bench_baselines.h"
#include "bench/bench_pipeline.h"

namespace {

using namespace ts::bench;

struct Stages {
  Samples pick, field, cut, label, total;
  unsigned failed = 0;
};

// The clicks that the library proposes, one after the other on the untouched scan; `total` runs from the point to the
// labels of all faces, and what it is more than the click itself counts as labelling.
void click_each(Pipeline &p, std::vector<std::uint32_t> &labels, Stages &stages) {
  forget_clicks(p);
  ts_segmentation *const s = p.segmentation.get();
  for (const Point &at : proposed_clicks(p)) {
    std::uint32_t click = 0, count = 0;
    ts_status status = TS_OK;
    const double total = ms_of([&] {
      status = ts_segment_click(s, at.data(), nullptr, &click);
      if (status == TS_OK)
        need_ok(ts_get_labels(s, labels.data(), static_cast<std::uint32_t>(labels.size()), &count), "ts_get_labels");
    });
    if (status != TS_OK) {
      ++stages.failed;
      continue;
    }
    // Not by ts_get_click, which works out what the click did not need.
    const auto &ms = s->session.click(click).ms;
    stages.pick.add(ms.pick);
    stages.field.add(ms.field);
    stages.cut.add(ms.cut);
    stages.label.add(ms.label + std::max(0., total - ms.total));
    stages.total.add(total);
  }
}

// The same scan with the paper's preset.
Pipeline by_the_paper(const Pipeline &p) {
  ts_segment_options options;
  need_ok(ts_segment_options_init(&options, sizeof options, TS_PRESET_PAPER), "ts_segment_options_init");
  ts_segmentation *segmentation = nullptr;
  need_ok(ts_segmentation_create(p.features.get(), &options, nullptr, &segmentation), "ts_segmentation_create");
  Pipeline paper;
  paper.segmentation.reset(segmentation);
  return paper;
}

std::string number(double x) {
  if (!std::isfinite(x)) return "null";
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", x);
  return text;
}

std::string json_of(const Stages &s) {
  return "{\"clicks\": " + std::to_string(s.total.size()) + ", \"failed\": " + std::to_string(s.failed) +
         ", \"pick\": " + number(s.pick.median()) + ", \"field\": " + number(s.field.median()) +
         ", \"cut\": " + number(s.cut.median()) + ", \"label\": " + number(s.label.median()) +
         ", \"total\": " + number(s.total.median()) + "}";
}

std::string measure(const Mesh &mesh, int rounds) {
  Pipeline p = prepare(mesh, 0);
  Pipeline paper = by_the_paper(p);
  const Problem problem = make_problem(surface_of(p), features_of(p));
  std::vector<std::uint32_t> labels(mesh.faces());
  Stages ours, theirs;
  click_each(p, labels, ours);  // warms up
  ours = {};
  Samples assemble, analyse, factorise, solve, field;
  const auto groups = static_cast<ts::mesh::Index>(features_of(p).groups.size());
  for (int round = 0; round < rounds; ++round) {  // in turns: what is divided by each other has seen the same machine
    click_each(p, labels, ours);
    click_each(paper, labels, theirs);
    const BaselineTimes times = click_with_eigen(problem, static_cast<ts::mesh::Index>(round) % groups);
    assemble.add(times.assemble);
    analyse.add(times.analyse);
    factorise.add(times.factorise);
    solve.add(times.solve);
    field.add(times.total());
  }
  const ts_prepare_times once = prepare_times(p);
  return "{\"vertices\": " + std::to_string(mesh.vertices()) + ", \"triangles\": " + std::to_string(mesh.faces()) +
         ", \"unknowns\": " + std::to_string(problem.unknowns) + ", \"rounds\": " + std::to_string(rounds) +
         ",\n \"prepare\": {\"intake\": " + number(p.intake_ms) + ", \"features\": " + number(p.features_ms) +
         ", \"weights\": " + number(once.weights) + ", \"factorise\": " + number(once.factorise) +
         ", \"total\": " + number(p.prepare_ms()) + "},\n \"ours\": " + json_of(ours) +
         ",\n \"paper_preset\": " + json_of(theirs) +
         ",\n \"paper_field\": {\"assemble\": " + number(assemble.median()) +
         ", \"analyse\": " + number(analyse.median()) + ", \"factorise\": " + number(factorise.median()) +
         ", \"solve\": " + number(solve.median()) + ", \"total\": " + number(field.median()) + "}}\n";
}

}  // namespace

int main(int argc, char **argv) {
  const int rounds = argc == 4 && std::string(argv[2]) == "--rounds" ? std::atoi(argv[3]) : argc == 2 ? 3 : 0;
  if (rounds < 1) {
    std::fprintf(stderr, "usage: ts-click-times MESH.ply [--rounds N]\n");
    return 2;
  }
  try {
    std::fputs(measure(read_mesh(argv[1]), rounds).c_str(), stdout);
    return 0;
  } catch (const std::exception &e) {
    std::fprintf(stderr, "ts-click-times: %s\n", e.what());
    return 1;
  }
}
