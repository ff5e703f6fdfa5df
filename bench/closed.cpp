// How the meshes of teeth stand the test: ts-closed SCAN... separates each scan by the clicks that the library proposes
// and writes a row a scan: are all teeth closed, watertight, manifold and consistently wound (OpenMesh), do they run
// through themselves near the cut (CGAL, exact), do open teeth and gingiva add up to the scan. A scan is a mesh file,
// or arch:SEED:CROWDING:TRIANGLES, a synthetic one.
#include <toothseg.h>
#include <toothseg_arch.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "tests/tooth/mesh_judge.h"

namespace {

void must(ts_status status) {
  if (status == TS_OK) return;
  std::fprintf(stderr, "%s\n", ts_last_error_message());
  std::exit(1);
}

double milliseconds() {
  using namespace std::chrono;
  return duration<double, std::milli>(steady_clock::now().time_since_epoch()).count();
}

ts_model *load(ts_context *context, const std::string &scan) {
  ts_model *model = nullptr;
  if (!scan.starts_with("arch:")) {
    must(ts_model_load(context, scan.c_str(), nullptr, nullptr, &model));
    return model;
  }
  unsigned seed = 1, triangles = 60000;
  double crowding = 0;
  std::sscanf(scan.c_str(), "arch:%u:%lf:%u", &seed, &crowding, &triangles);
  tsa_options o{};
  tsa_arch *arch = nullptr;
  if (tsa_options_init(&o, sizeof o) != TSA_OK) std::exit(1);
  o.seed = seed, o.crowding = crowding, o.triangles = triangles, o.jaw = seed % 2 ? TSA_JAW_UPPER : TSA_JAW_LOWER;
  if (tsa_create(&o, &arch) != TSA_OK) std::exit(1);
  std::uint32_t vertices = 0, faces = 0;
  if (tsa_get_positions(arch, nullptr, 0, &vertices) || tsa_get_triangles(arch, nullptr, 0, &faces)) std::exit(1);
  std::vector<double> xyz(3 * std::size_t{vertices});
  std::vector<std::uint32_t> corners(3 * std::size_t{faces});
  if (tsa_get_positions(arch, xyz.data(), vertices, &vertices) ||
      tsa_get_triangles(arch, corners.data(), faces, &faces))
    std::exit(1);
  tsa_destroy(arch);
  ts_mesh_input input{};
  must(ts_mesh_input_init(&input, sizeof input));
  input.scalar = TS_FLOAT64;
  input.positions = xyz.data();
  input.vertex_count = vertices;
  input.triangles = corners.data();
  input.triangle_count = faces;
  must(ts_model_create(context, &input, nullptr, nullptr, &model));
  return model;
}

struct Row {
  unsigned teeth = 0, closed = 0, watertight = 0, crossed = 0, inherited = 0, rims = 0, components = 0, trimmed = 0;
  std::size_t triangles = 0, fill = 0;
  double ms = 0, most_ms = 0, lost = 0, area = 0;
};

void look_at(const ts_mesh *mesh, Row &row, bool verbose, unsigned tooth) {
  ts_mesh_info info{};
  info.struct_size = sizeof info;
  must(ts_mesh_get_info(mesh, &info));
  std::vector<judge::Point> points(info.vertices);
  std::vector<judge::Face> faces(info.triangles);
  std::vector<std::uint8_t> flags(info.vertices);
  must(ts_mesh_get_positions(mesh, points.data()->data(), info.vertices, nullptr));
  must(ts_mesh_get_triangles(mesh, faces.data()->data(), info.triangles, nullptr));
  must(ts_mesh_get_vertex_flags(mesh, flags.data(), info.vertices, nullptr));
  ++row.closed;
  row.triangles += info.triangles;
  row.fill += info.fill_triangles;
  row.rims += info.closed_rims;
  row.components += info.components;
  row.trimmed += info.trimmed;
  row.lost += info.lost;
  row.watertight += judge::watertight(points, faces) && info.volume > 0;
  const auto pairs = judge::crossings_near(points, faces, flags);
  const std::size_t first = info.triangles - info.fill_triangles;
  const bool ours = std::ranges::any_of(pairs, [&](const auto &p) { return p[0] >= first || p[1] >= first; });
  row.crossed += ours;
  row.inherited += !ours && !pairs.empty();
  if (verbose)
    std::printf(
        "  tooth %u: %u triangles, %u fill, %u rims, %u pieces, %.1f mm2, %.1f mm3, lost %.2f, %zu crossings%s\n",
        tooth, info.triangles, info.fill_triangles, info.closed_rims, info.components, info.area, info.volume,
        info.lost, pairs.size(), ours ? " with the fill" : "");
}

Row measure(ts_context *context, const std::string &scan, bool verbose) {
  ts_model *model = load(context, scan);
  ts_features *features = nullptr;
  ts_segmentation *s = nullptr;
  must(ts_detect_features(model, nullptr, nullptr, &features));
  must(ts_segmentation_create(features, nullptr, nullptr, &s));
  std::uint32_t n = 0;
  must(ts_propose_clicks(s, nullptr, 0, &n));
  std::vector<double> clicks(3 * std::size_t{n});
  must(ts_propose_clicks(s, clicks.data(), n, &n));
  must(ts_segment_clicks(s, clicks.data(), n, nullptr, nullptr));
  must(ts_get_teeth(s, nullptr, 0, &n));
  std::vector<std::uint32_t> teeth(n);
  must(ts_get_teeth(s, teeth.data(), n, &n));
  Row row;
  row.teeth = n;
  ts_tooth_mesh_options options{};
  must(ts_tooth_mesh_options_init(&options, sizeof options));
  const auto area = [&](ts_mesh *mesh) {
    ts_mesh_info info{};
    info.struct_size = sizeof info;
    must(ts_mesh_get_info(mesh, &info));
    ts_mesh_destroy(mesh);
    return info.area;
  };
  for (const std::uint32_t tooth : teeth) {
    ts_mesh *mesh = nullptr;
    options.closed = 0;
    must(ts_tooth_mesh_create(s, tooth, &options, nullptr, &mesh));
    row.area += area(mesh);
    options.closed = 1;
    const double begin = milliseconds();
    if (ts_tooth_mesh_create(s, tooth, &options, nullptr, &mesh) != TS_OK) {
      if (verbose) std::printf("  tooth %u: %s\n", tooth, ts_last_error_message());
      continue;
    }
    const double ms = milliseconds() - begin;
    row.ms += ms;
    row.most_ms = std::max(row.most_ms, ms);
    look_at(mesh, row, verbose, tooth);
    ts_mesh_destroy(mesh);
  }
  ts_mesh *gingiva = nullptr;
  must(ts_gingiva_mesh_create(s, nullptr, nullptr, &gingiva));
  row.area += area(gingiva);
  ts_intake_report report{};
  report.struct_size = sizeof report;
  must(ts_model_get_report(model, &report));
  row.area = std::abs(row.area / report.area - 1);
  ts_segmentation_destroy(s);
  ts_features_destroy(features);
  ts_model_destroy(model);
  return row;
}

}  // namespace

int main(int argc, char **argv) {
  const bool verbose = argc > 1 && std::strcmp(argv[1], "--verbose") == 0;
  if (argc < 2 + verbose) {
    std::fprintf(stderr, "usage: ts-closed [--verbose] SCAN...\n");
    return 2;
  }
  if (!judge::has_cgal()) std::printf("built without CGAL: crossings are not looked for\n");
  ts_context *context = nullptr;
  must(ts_context_create(nullptr, &context));
  std::printf(
      "| scan | teeth | closed | watertight | crossing at the fill | scan's own crossings at the cut | rims closed | "
      "pieces | trimmed | triangles | of the fills | lost mm^2 | area off | ms a tooth, mean | most |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int i = 1 + verbose; i < argc; ++i) {
    const Row r = measure(context, argv[i], verbose);
    std::printf("| %s | %u | %u | %u | %u | %u | %u | %u | %u | %zu | %zu | %.2f | %.1e | %.0f | %.0f |\n", argv[i],
                r.teeth, r.closed, r.watertight, r.crossed, r.inherited, r.rims, r.components, r.trimmed, r.triangles,
                r.fill, r.lost, r.area, r.ms / std::max(1u, r.closed), r.most_ms);
    std::fflush(stdout);
  }
  ts_context_destroy(context);
  return 0;
}
