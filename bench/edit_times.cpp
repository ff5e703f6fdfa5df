// ts-edit-times: how long an edit of a cut takes beside a click, in one run on one mesh: medians and 95th percentiles
// over all teeth, ms, and edit over click, as JSON.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

#include "api/segmentation_handle.h"
#include "bench/bench_figures.h"
#include "bench/bench_pipeline.h"

namespace {

using namespace ts::bench;

struct Kind {
  const char *name;
  Samples ms;
  unsigned refused = 0;
};

struct Measured {
  Samples click;
  Kind drag{"drag", {}}, draw{"draw", {}}, offset{"offset", {}}, smooth{"smooth", {}};
};

// A point of the cut, moved away from the middle of the loop and back onto the surface.
Point beside(const Pipeline &p, const ts::cut::Polyline &line, std::size_t i, double mm) {
  ts::mesh::Vec3 middle = ts::mesh::Vec3::Zero();
  for (const auto &q : line.points) middle += q.position / static_cast<double>(line.points.size());
  const ts::mesh::Vec3 at = line.points[i].position + mm * (line.points[i].position - middle).normalized();
  const ts::mesh::Vec3 on = p.model->state->nearest(at).position;
  return {on.x(), on.y(), on.z()};
}

// Each edit on the cut of the click.
void time_edit(ts_segmentation *s, std::uint32_t tooth, Kind &kind, const std::function<ts_status()> &edit) {
  ts_status status = TS_OK;
  const double ms = ms_of([&] { status = edit(); });
  if (status == TS_OK)
    kind.ms.add(ms);
  else
    ++kind.refused;
  need_ok(ts_cut_reset(s, tooth), "ts_cut_reset");
}

void measure(Pipeline &p, std::size_t round, Measured &m) {
  ts_segmentation *s = p.segmentation.get();
  forget_clicks(p);
  for (const Point &at : proposed_clicks(p)) {
    std::uint32_t click = 0;
    ts_status status = TS_OK;
    const double ms = ms_of([&] { status = ts_segment_click(s, at.data(), nullptr, &click); });
    if (status != TS_OK) continue;
    m.click.add(ms);
    for (const auto group : {s->session.click(click).target, s->session.click(click).neighbour}) {
      const ts::tooth::Tooth *tooth = s->session.tooth(group);
      if (!tooth || tooth->loops.empty()) continue;
      const std::uint32_t id = s->prepared->features->set.groups()[group].id;
      const ts::cut::Polyline line = tooth->loops[0].line;
      const std::size_t n = line.points.size(), i = (round * 37) % n;
      const double way = round % 2 ? 1.0 : -0.6;
      time_edit(s, id, m.drag, [&] {
        return ts_cut_drag(s, id, 0, static_cast<std::uint32_t>(i), beside(p, line, i, way).data(), 0, nullptr);
      });
      // A third of the loop.
      std::vector<Point> stroke;
      for (std::size_t k = 0; k <= 8; ++k)
        stroke.push_back(beside(p, line, (i + k * n / 24) % n, k == 0 || k == 8 ? 0 : way / 2));
      time_edit(s, id, m.draw, [&] {
        return ts_cut_draw(s, id, stroke.front().data(), static_cast<std::uint32_t>(stroke.size()), nullptr);
      });
      time_edit(s, id, m.offset, [&] { return ts_cut_offset(s, id, way / 2, nullptr); });
      time_edit(s, id, m.smooth, [&] { return ts_cut_smooth(s, id, 0.5, nullptr); });
    }
  }
}

std::string json_of(const Kind &kind, const Samples &click) {
  char text[256];
  std::snprintf(text, sizeof text,
                "\"%s\": {\"edits\": %zu, \"refused\": %u, \"median\": %.3f, \"p95\": %.3f, \"over_click\": %.3f, "
                "\"p95_over_click\": %.3f}",
                kind.name, kind.ms.size(), kind.refused, kind.ms.median(), kind.ms.quantile(0.95),
                kind.ms.median() / click.median(), kind.ms.quantile(0.95) / click.median());
  return text;
}

}  // namespace

int main(int argc, char **argv) {
  if (argc < 2 || argc > 4) {
    std::fprintf(stderr, "usage: ts-edit-times MESH.ply|TRIANGLES [ROUNDS [THREADS]]\n");
    return 2;
  }
  try {
    const int triangles = std::atoi(argv[1]);
    const Mesh mesh = triangles > 0 ? make_arch(static_cast<std::uint32_t>(triangles)) : read_mesh(argv[1]);
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5, threads = argc > 3 ? std::atoi(argv[3]) : 0;
    Pipeline p = prepare(mesh, static_cast<unsigned>(threads));
    Measured m;
    measure(p, 0, m);  // warms up
    m = {};
    for (int round = 0; round < rounds; ++round) measure(p, static_cast<std::size_t>(round), m);
    std::printf(
        "{\"triangles\": %u, \"click\": {\"clicks\": %zu, \"median\": %.3f, \"p95\": %.3f},\n %s,\n %s,\n %s,\n %s}\n",
        mesh.faces(), m.click.size(), m.click.median(), m.click.quantile(0.95), json_of(m.drag, m.click).c_str(),
        json_of(m.draw, m.click).c_str(), json_of(m.offset, m.click).c_str(), json_of(m.smooth, m.click).c_str());
    return 0;
  } catch (const std::exception &e) {
    std::fprintf(stderr, "ts-edit-times: %s\n", e.what());
    return 1;
  }
}
