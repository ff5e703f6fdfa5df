// Accuracy and time of the segmentation on folders of labelled scans.
//
//   bench_field [--paper] [--points cusp|core|auto] [--most N] [--clicks proposed|each|pairs] [--seed N] [--set
//   name=value]... [--out DIR] FOLDER...
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "bench/field_labels.h"
#include "features/detect.h"
#include "tooth/session.h"

namespace {

using namespace ts;
using bench::Index;

struct Setup {
  tooth::Options options = tooth::default_options();
  bench::PointsFrom points = bench::PointsFrom::cusp;
  bool automatic = false;  // features as detected; no label is used
  std::size_t most = 5;
  std::string clicks = "proposed";  // or "each": one a tooth at random, or "pairs": as in the paper, N / 2
  std::uint64_t seed = 1;
  std::string out;
  bool verbose = false;
};

void set_option(tooth::Options &o, const std::string &text) {
  const std::size_t eq = text.find('=');
  const std::string name = text.substr(0, eq);
  const double x = std::stod(text.substr(eq + 1));
  if (name == "weights")
    o.weights = static_cast<field::Scheme>(static_cast<int>(x));
  else if (name == "background")
    o.background = static_cast<tooth::Background>(static_cast<int>(x));
  else if (name == "cut_rule")
    o.cut_rule = static_cast<tooth::CutRule>(static_cast<int>(x));
  else if (name == "alpha")
    o.alpha = x;
  else if (name == "beta")
    o.beta = x;
  else if (name == "theta")
    o.theta = x;
  else if (name == "c0")
    o.c0 = x;
  else if (name == "normal_radius")
    o.normal_radius = x;
  else if (name == "seed_radius")
    o.seed_radius = x;
  else if (name == "gingiva_distance")
    o.gingiva_distance = x;
  else if (name == "hole_area")
    o.hole_area = x;
  else if (name == "refine_band")
    o.refine_band = x;
  else if (name == "smooth_radius")
    o.smooth_radius = x;
  else if (name == "click_concavity")
    o.click_concavity = x;
  else if (name == "points_per_group")
    o.points_per_group = static_cast<std::uint32_t>(x);
  else if (name == "reject_outliers")
    o.reject_outliers = x != 0;
  else
    throw std::runtime_error("unknown option " + name);
}

mesh::SurfacePoint face_centre(const mesh::Surface &s, Index f) {
  mesh::SurfacePoint p;
  p.face = f;
  p.barycentric.setConstant(1.0 / 3);
  const auto &t = s.triangle[f];
  p.position = (s.position[t[0]] + s.position[t[1]] + s.position[t[2]]) / 3;
  return p;
}

mesh::SurfacePoint near(const mesh::Surface &s, const mesh::Vec3 &q) {
  Index best = 0;
  for (Index v = 0; v < s.vertices(); ++v)
    if ((s.position[v] - q).squaredNorm() < (s.position[best] - q).squaredNorm()) best = v;
  mesh::SurfacePoint p;
  p.face = s.vertex_faces[best].front();
  p.position = s.position[best];
  for (int k = 0; k < 3; ++k) p.barycentric[k] = s.triangle[p.face][static_cast<std::size_t>(k)] == best;
  return p;
}

struct Totals {
  Vec<double> iou;
  int false_parts = 0, clicks = 0, target_right = 0, neighbour_right = 0, refused = 0;
};

void run(const std::string &folder, const Setup &setup, Totals &totals) {
  const bench::ScanFolder scan = bench::read_scan_folder(folder);
  if (scan.label.empty()) return;
  const bench::LabelledTeeth teeth = bench::labelled_teeth(scan);
  const Executor executor(1);
  const features::Features features = setup.automatic
                                          ? features::detect(scan.surface, {}, executor, {})
                                          : bench::features_from_labels(scan, teeth, setup.points, setup.most);
  const Vec<Index> tooth_of = bench::tooth_of_groups(scan, teeth, features);
  const auto begin = std::chrono::steady_clock::now();
  const tooth::Segmenter segmenter(scan.surface, features, setup.options, executor);
  const double prepare = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  Vec<mesh::SurfacePoint> points;
  Vec<Index> clicked, beside;  // the teeth meant
  const Index count = static_cast<Index>(teeth.label.size());
  std::uint64_t state = setup.seed;
  const bool pairs = setup.clicks == "pairs";
  if (setup.clicks == "proposed") {
    for (const mesh::Vec3 &p : segmenter.propose_clicks()) points.push_back(near(scan.surface, p));
  } else {
    for (Index t = 0; t < count; t += pairs ? 2 : 1) {
      clicked.push_back(t);
      beside.push_back(!pairs ? mesh::none : t + 1 < count ? t + 1 : t - 1);
      points.push_back(face_centre(scan.surface, bench::random_crown_face(scan, teeth, t, beside.back(), state)));
    }
  }
  tooth::Session session(scan.surface);
  tooth::ClickTimes ms;
  for (Index i = 0; i < points.size(); ++i) {
    try {
      tooth::Click click = segmenter.click(points[i], session.teeth());
      ms.pick += click.ms.pick, ms.field += click.ms.field, ms.cut += click.ms.cut, ms.label += click.ms.label;
      if (!clicked.empty()) {
        ++totals.clicks;
        const bool right = tooth_of[click.target] == clicked[i];
        const Index other = click.neighbour == mesh::none ? mesh::none : tooth_of[click.neighbour];
        totals.target_right += right;
        totals.neighbour_right += right && other != mesh::none &&
                                  (pairs ? other == beside[i] : other == clicked[i] + 1 || other + 1 == clicked[i]);
      }
      session.add(std::move(click));
    } catch (const Error &e) {
      ++totals.refused;
      std::printf("  %s\n", e.what());
    }
  }
  const Vec<std::uint32_t> labels = session.labels();
  const bench::Scores scores = bench::score_labels(scan, teeth, labels);
  double mean = 0, least = 1;
  for (const double x : scores.iou) mean += x / static_cast<double>(scores.iou.size()), least = std::min(least, x);
  const double n = static_cast<double>(points.size());
  std::printf(
      "%-20s %3zu teeth  iou %.3f min %.3f  false %d  prepare %5.0f (%4.0f + %4.0f) click pick %.1f field %.1f cut "
      "%.1f label %.1f ms\n",
      scan.name.c_str(), teeth.label.size(), mean, least, scores.false_parts, prepare, segmenter.times().weights,
      segmenter.times().factorise, ms.pick / n, ms.field / n, ms.cut / n, ms.label / n);
  if (setup.verbose)
    for (Index i = 0; i < scores.iou.size(); ++i) {
      const tooth::Tooth *t = setup.automatic ? nullptr : session.tooth(i);
      if (scores.iou[i] < 0.9)
        std::printf("    tooth %d: %.3f area %.0f confidence %.2f loops %zu warnings %u\n", teeth.label[i],
                    scores.iou[i], t ? t->area : 0, t ? t->confidence : 0, t ? t->loops.size() : 0,
                    t ? t->warnings : 0);
    }
  if (!setup.out.empty()) {
    std::ofstream file(setup.out + "/" + scan.name + ".txt");
    for (const std::uint32_t l : labels) file << l << '\n';
  }
  totals.iou.insert(totals.iou.end(), scores.iou.begin(), scores.iou.end());
  totals.false_parts += scores.false_parts;
}

}  // namespace

int main(int argc, char **argv) {
  Setup setup;
  Totals totals;
  try {
    for (int i = 1; i < argc; ++i) {
      const std::string a = argv[i];
      if (a == "--paper")
        setup.options = tooth::paper_options();
      else if (a == "--points" && std::string(argv[i + 1]) == "auto")
        setup.automatic = true, ++i;
      else if (a == "--points")
        setup.points = std::string(argv[++i]) == "core" ? bench::PointsFrom::core : bench::PointsFrom::cusp;
      else if (a == "--most")
        setup.most = std::stoul(argv[++i]);
      else if (a == "--clicks")
        setup.clicks = argv[++i];
      else if (a == "--seed")
        setup.seed = std::stoull(argv[++i]);
      else if (a == "--set")
        set_option(setup.options, argv[++i]);
      else if (a == "--out")
        setup.out = argv[++i];
      else if (a == "-v")
        setup.verbose = true;
      else
        run(a, setup, totals);
    }
  } catch (const std::exception &e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
  const double n = std::max<double>(1, static_cast<double>(totals.iou.size()));
  double mean = 0, least = 1, good = 0, bad = 0;
  for (const double x : totals.iou) {
    mean += x / n;
    least = std::min(least, x);
    good += (x >= 0.9) / n;
    bad += (x < 0.7) / n;
  }
  std::printf("all: %zu teeth, mean %.4f min %.3f, >= .9 %.1f %%, < .7 %.1f %%, false %d, refused %d",
              totals.iou.size(), mean, least, 100 * good, 100 * bad, totals.false_parts, totals.refused);
  if (totals.clicks)
    std::printf(", target right %.1f %%, neighbour too %.1f %%", 100.0 * totals.target_right / totals.clicks,
                100.0 * totals.neighbour_right / totals.clicks);
  std::printf("\n");
}
