// The C++ layer says what the C functions say. SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <thread>
#include <toothseg.hpp>

extern "C" {
#include "fixture.h"
#include "harness.h"
}

namespace {

struct ArchMesh {
  std::vector<double> xyz;
  std::vector<toothseg::Index> triangles;
};

ArchMesh arch_mesh(std::uint32_t triangles) {
  mesh m = make_arch(triangles);
  ArchMesh out{{m.xyz, m.xyz + 3 * std::size_t{m.vertices}}, {m.triangles, m.triangles + 3 * std::size_t{m.faces}}};
  free_mesh(&m);
  return out;
}

template <class Call>
std::optional<ts_status> status_thrown(Call call) {
  try {
    call();
  } catch (const toothseg::Exception &e) {
    CHECK(std::strlen(e.what()) > 0);
    return e.status();
  }
  return std::nullopt;
}

const toothseg::Point far_away{1000, 0, 0};

void the_whole_way() {
  const ArchMesh arch = arch_mesh(20000);
  toothseg::Context context;
  toothseg::Model model(context, toothseg::mesh_input(arch.xyz, arch.triangles));
  context = toothseg::Context();  // the model keeps its own
  const ts_intake_report report = model.report();
  CHECK(report.input_faces == arch.triangles.size() / 3);
  CHECK(model.positions().size() == report.vertices && model.triangles().size() == report.faces);
  CHECK(model.face_sources().size() == report.faces && model.vertex_map().size() == report.input_vertices);
  CHECK(model.nearest(model.positions().front()).distance == 0);
  CHECK(status_thrown([&] { model.raycast(far_away, {1, 0, 0}); }) == TS_E_NOT_FOUND);

  const toothseg::Features features = toothseg::Features::detect(model);
  CHECK(features.groups().size() > 4 && !features.points().empty() && !features.arch().empty());
  CHECK(features.info().groups == features.groups().size());
  CHECK(features.occlusal()[2] > 0.9);

  toothseg::Segmentation segmentation(features);
  std::vector<toothseg::Point> clicks = segmentation.propose_clicks();
  const toothseg::Index first = segmentation.click(clicks.front());
  CHECK(first == 0);
  const ts_click_info info = segmentation.click_info(first);
  CHECK(segmentation.teeth().size() == 2);
  clicks.push_back(far_away);
  const std::vector<ts_status> statuses = segmentation.clicks(clicks);
  CHECK(statuses.size() == clicks.size() && statuses.back() == TS_E_CLICK_OFF_SURFACE);
  CHECK(segmentation.clicks({}).empty());
  CHECK(segmentation.click_count() == clicks.size());
  CHECK(segmentation.teeth().size() == features.groups().size());
  CHECK(segmentation.labels().size() == report.input_faces);

  segmentation.assign_numbers();
  const ts_number_info number = segmentation.number(info.target);
  CHECK(segmentation.jaw().jaw == TS_JAW_UPPER && number.fdi / 10 <= 2);
  segmentation.set_number(info.target, number.fdi);
  CHECK(segmentation.number(info.target).set_by_hand == 1);

  const ts_tooth_info tooth = segmentation.tooth(info.target);
  CHECK(segmentation.tooth_faces(info.target).size() == tooth.faces);
  CHECK(segmentation.tooth_vertices(info.target).size() == tooth.vertices);
  CHECK(!segmentation.tooth_seeds(info.target).empty());
  const toothseg::Cut cut = segmentation.cut(info.target);
  CHECK(cut.points.size() == cut.info.points && cut.info.length > 0);

  segmentation.offset_cut(info.target, 0.2);
  segmentation.smooth_cut(info.target, 0.1);
  CHECK(segmentation.tooth(info.target).area > tooth.area);
  CHECK(segmentation.cut_edits(info.target).size() == 2);
  CHECK(status_thrown([&] { segmentation.drag_cut(info.target, 99, 0, {0, 0, 0}); }) == TS_E_NOT_FOUND);
  CHECK(status_thrown([&] { segmentation.draw_cut(info.target, {}); }) == TS_E_INVALID_ARGUMENT);
  segmentation.reset_cut(info.target);
  CHECK(segmentation.tooth(info.target).area == tooth.area);
  CHECK(segmentation.field(0).size() == report.vertices && segmentation.histogram(0).size() == 50);
  const std::vector<ts_contour_info> contours = segmentation.contours(0);
  CHECK(contours.size() == 100);
  for (std::size_t c = 0; c < contours.size(); c += 33) {
    std::size_t points = 0;
    const std::vector<toothseg::Polyline> lines = segmentation.contour(0, static_cast<toothseg::Index>(c));
    for (const toothseg::Polyline &line : lines) points += line.points.size();
    CHECK(lines.size() == contours[c].polylines && points == contours[c].points);
  }
  CHECK(segmentation.prepare_times().intake > 0);
}

void failures_are_exceptions() {
  const toothseg::Context context;
  CHECK(status_thrown([&] { toothseg::Model::load(context, "no/such/scan.stl"); }) == TS_E_FILE_OPEN);
  CHECK(status_thrown([&] { toothseg::Model::read(context, "prose", 5); }) == TS_E_FILE_FORMAT);
  const ArchMesh arch = arch_mesh(5000);
  const toothseg::Model model(context, toothseg::mesh_input(arch.xyz, arch.triangles));
  toothseg::Features features(model);
  CHECK(status_thrown([&] { toothseg::Segmentation nothing(features); }) == TS_E_NO_CONSTRAINT);
  CHECK(status_thrown([&] { features.remove_point(0); }) == TS_E_NOT_FOUND);
  CHECK(status_thrown([&] { features.add_point({0, 0, 0}, 99); }) == TS_E_NOT_FOUND);
  const auto place = features.add_point({0, 0, 0});
  CHECK(features.points().size() == 1 && features.points()[0].id == place.point);
  features.move_point(place.point, {20, 0, 0});
  CHECK(features.points()[0].position[0] > 0);
  const toothseg::Index second = features.add_point({-20, 0, 0}, place.group).point;
  CHECK(features.set_group(second) != place.group && features.groups().size() == 2);
  features.remove_point(second);
  features.set_occlusal({0, 0, -2});
  CHECK(features.occlusal()[2] == -1);
  const toothseg::Features copy = features.clone();
  features.remove_group(place.group);
  CHECK(features.points().empty() && copy.points().size() == 1);
  ts_context_options options = toothseg::context_options();
  options.threads = 5000;
  CHECK(status_thrown([&] { toothseg::Context{options}; }) == TS_E_INVALID_ARGUMENT);
}

void owners_move() {
  const ArchMesh arch = arch_mesh(5000);
  toothseg::Context context, other;
  toothseg::Model model(context, toothseg::mesh_input(arch.xyz, arch.triangles));
  ts_model *handle = model.get();
  toothseg::Model moved = std::move(model);
  CHECK(moved.get() == handle && model.get() == nullptr);
  model = std::move(moved);
  CHECK(model.get() == handle);
  other = std::move(context);
  CHECK(model.report().faces > 0);
  const std::vector<float> floats(arch.xyz.begin(), arch.xyz.end());
  CHECK(toothseg::Model(other, toothseg::mesh_input(floats, arch.triangles)).report().faces == model.report().faces);
}

void jobs() {
  const ArchMesh arch = arch_mesh(10000);
  const toothseg::Context context;
  const toothseg::Model model(context, toothseg::mesh_input(arch.xyz, arch.triangles));

  int calls = 0;
  toothseg::Job watching(context, [&](double, const char *) { return ++calls, true; });
  toothseg::Job moved = std::move(watching);  // the handle still finds its callback
  const toothseg::Features features = toothseg::Features::detect(model, toothseg::feature_options(), &moved);
  CHECK(calls > 0 && moved.progress() == 1);

  toothseg::Job stopping(context, [](double fraction, const char *) { return fraction < 0.2; });
  CHECK(status_thrown([&] { toothseg::Features::detect(model, toothseg::feature_options(), &stopping); }) ==
        TS_E_CANCELLED);

  toothseg::Job throwing(context, [](double, const char *) -> bool { throw std::runtime_error("the host's own"); });
  bool came_out = false;
  try {
    toothseg::Segmentation never(features, toothseg::segment_options(), &throwing);
  } catch (const std::runtime_error &e) {
    came_out = std::strcmp(e.what(), "the host's own") == 0;
  }
  CHECK(came_out);

  toothseg::Job silent(context);
  std::thread([&] { silent.cancel(); }).join();
  CHECK(status_thrown([&] { toothseg::Features::detect(model, toothseg::feature_options(), &silent); }) ==
        TS_E_CANCELLED);
  silent.reset();
  CHECK(!toothseg::Features::detect(model, toothseg::feature_options(), &silent).points().empty());
}

// Calls that take a const handle may run at the same time; each thread has a message of its own.
void threads_of_the_host() {
  const ArchMesh arch = arch_mesh(10000);
  const toothseg::Context context;
  const toothseg::Model model(context, toothseg::mesh_input(arch.xyz, arch.triangles));
  const toothseg::Features features = toothseg::Features::detect(model);
  toothseg::Segmentation segmentation(features);
  segmentation.clicks(segmentation.propose_clicks());
  const std::vector<toothseg::Index> expected = segmentation.labels();
  const std::vector<double> field = segmentation.field(0);
  std::vector<int> right(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < right.size(); ++t)
    threads.emplace_back([&, t] {
      int good = segmentation.labels() == expected && segmentation.field(0) == field;
      toothseg::Segmentation own(features);  // of shared features
      own.clicks(own.propose_clicks());
      good = good && own.labels() == expected;
      const std::string name = "missing-" + std::to_string(t);
      try {
        toothseg::Model::load(context, name);
        good = 0;
      } catch (const toothseg::Exception &e) {
        good = good && std::string(e.what()).find(name) != std::string::npos;
      }
      right[t] = good;
    });
  for (std::thread &thread : threads) thread.join();
  for (const int good : right) CHECK(good);
}

// --------------------------------------------------------------------------------------- teeth corrected, kept,
// written

// A scan with all its teeth. It is made once; a test takes back the steps that it made.
struct Scan {
  ArchMesh arch = arch_mesh(20000);
  toothseg::Context context;
  toothseg::Model model{context, toothseg::mesh_input(arch.xyz, arch.triangles)};
  toothseg::Features features = toothseg::Features::detect(model);
  toothseg::Segmentation segmentation{features};
  std::vector<toothseg::Index> teeth;

  Scan() {
    segmentation.segment_all();
    teeth = segmentation.teeth();
  }

  // A feature point of a tooth.
  toothseg::Point on(toothseg::Index tooth) const {
    for (const ts_feature_point &p : features.points())
      if (p.group == tooth) return {p.position[0], p.position[1], p.position[2]};
    return far_away;
  }

  // From the middle of a tooth.
  double distance(toothseg::Index tooth, const toothseg::Point &p) const {
    const ts_tooth_frame frame = segmentation.tooth_frame(tooth);
    return std::hypot(frame.centre[0] - p[0], frame.centre[1] - p[1], frame.centre[2] - p[2]);
  }

  void take_back() {
    while (segmentation.history().undo > 1) segmentation.undo();
  }
};

Scan &scan() {
  static Scan made;
  return made;
}

void corrections() {
  Scan &s = scan();
  toothseg::Segmentation &segmentation = s.segmentation;
  const std::size_t count = s.teeth.size();
  CHECK(count == s.features.groups().size());
  const toothseg::Index tooth = s.teeth[2], beside = s.teeth[3];

  segmentation.merge_teeth(tooth, beside);
  CHECK(segmentation.teeth().size() == count - 1);
  CHECK(segmentation.tooth(tooth).faces > 0);
  CHECK(status_thrown([&] { segmentation.tooth(beside); }) == TS_E_NOT_FOUND);
  const toothseg::Index second = segmentation.split_tooth(tooth, s.on(tooth), s.on(beside));
  CHECK(second != tooth && segmentation.teeth().size() == count);
  CHECK(s.distance(second, s.on(beside)) < s.distance(second, s.on(tooth)));
  s.take_back();

  const std::size_t seeds = segmentation.tooth_seeds(tooth).size();
  segmentation.include_point(tooth, s.on(beside));
  CHECK(segmentation.tooth_seeds(tooth).size() > seeds);
  CHECK(segmentation.changes().size() == 2);
  segmentation.exclude_point(tooth, s.on(beside));
  CHECK(segmentation.tooth_seeds(tooth).size() == seeds);
  CHECK(status_thrown([&] { segmentation.include_point(tooth, far_away); }) == TS_E_CLICK_OFF_SURFACE);
  CHECK(status_thrown([&] { segmentation.exclude_point(TS_NONE, s.on(tooth)); }) == TS_E_NOT_FOUND);
  s.take_back();

  segmentation.remove_tooth(tooth);
  CHECK(segmentation.teeth().size() == count - 1);
  const std::vector<ts_review_item> review = segmentation.review();
  CHECK(!review.empty() && review[0].tooth == tooth && review[0].separated == 0);
  s.take_back();

  CHECK(!segmentation.locked(tooth));
  segmentation.set_locked(tooth, true);
  CHECK(segmentation.locked(tooth));
  CHECK(status_thrown([&] { segmentation.remove_tooth(tooth); }) == TS_E_LOCKED);
  CHECK(status_thrown([&] { segmentation.set_locked(tooth, true); }) == TS_E_NO_CHANGE);
  segmentation.set_locked(tooth, false);
  CHECK(!segmentation.locked(tooth));
  s.take_back();
}

void cuts_are_edited() {
  Scan &s = scan();
  const toothseg::Index tooth = s.teeth[2];
  toothseg::Segmentation &segmentation = s.segmentation;
  const toothseg::Cut before = segmentation.cut(tooth);
  const toothseg::Point up = s.features.occlusal();
  std::size_t lowest = 0;
  const auto below = [&](std::size_t point, double mm) {
    toothseg::Point p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = before.points[point].position[k] - mm * up[k];
    return p;
  };
  for (std::size_t i = 0; i < before.points.size(); ++i)
    if (below(i, 0)[2] < below(lowest, 0)[2]) lowest = i;
  segmentation.drag_cut(tooth, 0, static_cast<toothseg::Index>(lowest), below(lowest, 0.5));
  CHECK(segmentation.cut_edits(tooth).size() == 1 && segmentation.cut_edits(tooth)[0].kind == TS_EDIT_DRAG);
  const std::size_t n = before.points.size();
  segmentation.draw_cut(tooth, {below((lowest + n - 4) % n, 0), below(lowest, 0.8), below((lowest + 4) % n, 0)});
  CHECK(segmentation.cut_edits(tooth).size() == 2 && segmentation.cut_edits(tooth)[1].kind == TS_EDIT_DRAW);
  CHECK(segmentation.cut(tooth).info.length != before.info.length);
  segmentation.reset_cut(tooth);
  CHECK(segmentation.cut(tooth).info.length == before.info.length);
  // Teeth that reach over their neighbours.
  const std::size_t overlaps = segmentation.overlaps().size();
  for (const toothseg::Index t : s.teeth) status_thrown([&] { segmentation.offset_cut(t, 0.3); });
  CHECK(segmentation.overlaps().size() > overlaps);
  for (const ts_overlap &o : segmentation.overlaps()) CHECK(o.winner != o.loser && o.faces > 0);
  s.take_back();
}

void steps_are_taken_back() {
  Scan &s = scan();
  toothseg::Segmentation &segmentation = s.segmentation;
  const std::vector<toothseg::Index> labels = segmentation.labels();
  segmentation.remove_tooth(s.teeth[0]);
  const std::vector<toothseg::Index> without = segmentation.labels();
  CHECK(without != labels);
  CHECK(segmentation.history().undo == 2 && segmentation.history().redo == 0);
  segmentation.undo();
  CHECK(segmentation.labels() == labels && segmentation.history().redo == 1);
  segmentation.redo();
  CHECK(segmentation.labels() == without);
  CHECK(segmentation.changes() == std::vector<toothseg::Index>{s.teeth[0]});
  CHECK(status_thrown([&] { segmentation.redo(); }) == TS_E_NO_HISTORY);
  // What is missing comes again, and says how far it is.
  int calls = 0;
  toothseg::Job job(s.context, [&](double, const char *) { return ++calls, true; });
  segmentation.segment_all(&job);
  CHECK(calls > 0 && segmentation.teeth() == s.teeth);
  s.take_back();
  CHECK(segmentation.labels() == labels);
}

void changes_are_told() {
  Scan &s = scan();
  std::vector<std::vector<toothseg::Index>> told;
  s.segmentation.on_change([&](const std::vector<toothseg::Index> &teeth) { told.push_back(teeth); });
  s.segmentation.remove_tooth(s.teeth[1]);
  CHECK(told.size() == 1 && told[0] == s.segmentation.changes());
  CHECK(status_thrown([&] { s.segmentation.remove_tooth(s.teeth[1]); }) == TS_E_NOT_FOUND);
  CHECK(told.size() == 1);
  toothseg::Segmentation moved = std::move(s.segmentation);  // the handle still finds its callback
  moved.undo();
  CHECK(told.size() == 2 && told[1] == told[0]);
  CHECK(status_thrown([&] { s.segmentation.undo(); }) == TS_E_NULL);
  CHECK(status_thrown([&] { s.segmentation.on_change({}); }) == TS_E_NULL);
  s.segmentation = std::move(moved);

  s.segmentation.on_change([](const std::vector<toothseg::Index> &) { throw std::runtime_error("the host's own"); });
  bool came_out = false;
  try {
    s.segmentation.set_locked(s.teeth[1], true);
  } catch (const std::runtime_error &e) {
    came_out = std::strcmp(e.what(), "the host's own") == 0;
  }
  CHECK(came_out && s.segmentation.locked(s.teeth[1]));  // the change stands

  s.segmentation.on_change({});
  s.segmentation.undo();
  CHECK(told.size() == 2 && !s.segmentation.locked(s.teeth[1]));
}

void sessions_are_resumed() {
  Scan &s = scan();
  const char *const path = "hpp_session.json";
  s.segmentation.set_locked(s.teeth[4], true);
  const std::string text = s.segmentation.write_session();
  toothseg::Session read = toothseg::Session::read(s.model, text);
  CHECK(read.segmentation.labels() == s.segmentation.labels() && read.segmentation.locked(s.teeth[4]));
  CHECK(read.features.points().size() == s.features.points().size());
  CHECK(read.segmentation.write_session() == text);
  s.segmentation.save_session(path);
  const toothseg::Session loaded = toothseg::Session::load(s.model, path);
  CHECK(loaded.segmentation.write_session() == text);
  std::remove(path);

  read.segmentation.set_history_limit(1);
  CHECK(read.segmentation.history().limit == 1 && read.segmentation.history().complete == 0);
  CHECK(status_thrown([&] { read.segmentation.undo(); }) == TS_E_NO_HISTORY);

  CHECK(status_thrown([&] { toothseg::Session::load(s.model, path); }) == TS_E_FILE_OPEN);
  CHECK(status_thrown([&] { s.segmentation.save_session("no/such/folder"); }) == TS_E_FILE_WRITE);
  CHECK(status_thrown([&] { toothseg::Session::read(s.model, text.substr(0, text.size() / 2)); }) ==
        TS_E_FILE_TRUNCATED);
  const ArchMesh other = arch_mesh(5000);
  const toothseg::Model of_another(s.context, toothseg::mesh_input(other.xyz, other.triangles));
  CHECK(status_thrown([&] { toothseg::Session::read(of_another, text); }) == TS_E_MISMATCH);
  toothseg::Job stopping(s.context, [](double, const char *) { return false; });
  CHECK(status_thrown([&] { toothseg::Session::read(s.model, text, &stopping); }) == TS_E_CANCELLED);
  s.take_back();
}

void meshes_are_made_and_written() {
  const Scan &s = scan();
  const toothseg::Index tooth = s.teeth[5];
  ts_tooth_mesh_options options = toothseg::tooth_mesh_options();
  options.closed = 1;
  toothseg::Mesh crown = toothseg::Mesh::tooth(s.segmentation, tooth, options);
  const ts_mesh_info info = crown.info();
  CHECK(info.label == s.segmentation.tooth(tooth).label && info.open_rims == 0 && info.volume > 0);
  CHECK(crown.positions().size() == info.vertices && crown.normals().size() == info.vertices);
  const toothseg::Point normal = crown.normals().front();
  CHECK_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-9);
  CHECK(s.distance(tooth, crown.positions().front()) < 15);
  std::uint32_t on_cut = 0;
  for (const std::uint8_t flags : crown.vertex_flags()) on_cut += (flags & TS_VERTEX_ON_CUT) != 0;
  CHECK(crown.vertex_flags().size() == info.vertices && on_cut == info.cut_vertices);
  const std::vector<toothseg::Triangle> triangles = crown.triangles();
  CHECK(triangles.size() == info.triangles && triangles.back()[2] < info.vertices);
  CHECK(crown.faces().size() == info.triangles && crown.faces().back() == TS_NONE);  // closed by the last
  CHECK(toothseg::Mesh::gingiva(s.segmentation).info().label == 0);
  CHECK(status_thrown([&] { toothseg::Mesh::tooth(s.segmentation, TS_NONE); }) == TS_E_NOT_FOUND);

  const char *const crown_path = "hpp_crown.ply", *const scan_path = "hpp_scan.ply";
  ts_intake_options any_size = toothseg::intake_options();
  any_size.unit = TS_UNIT_MM;
  crown.save(crown_path, TS_OUTPUT_PLY);
  CHECK(toothseg::Model::load(s.context, crown_path, any_size).report().input_faces == info.triangles);
  std::remove(crown_path);
  ts_save_options whole = toothseg::save_options();
  whole.whole_faces = 1;
  s.segmentation.save(scan_path, TS_OUTPUT_PLY, whole);
  CHECK(toothseg::Model::load(s.context, scan_path).report().input_faces == s.model.report().faces);
  s.segmentation.save(scan_path, TS_OUTPUT_PLY);  // split along the cuts
  CHECK(toothseg::Model::load(s.context, scan_path).report().input_faces > s.model.report().faces);
  std::remove(scan_path);
  CHECK(status_thrown([&] { crown.save("no/such/folder", TS_OUTPUT_STL); }) == TS_E_FILE_WRITE);

  const ts_tooth_frame frame = s.segmentation.tooth_frame(tooth);
  CHECK(frame.width > 2 && frame.width < 15 && frame.height > 2);
  CHECK(s.segmentation.memory().segmentation > 0);

  const toothseg::Mesh moved = std::move(crown);
  CHECK(moved.info().vertices == info.vertices);
  CHECK(status_thrown([&] { crown.info(); }) == TS_E_NULL);
  CHECK(status_thrown([&] { crown.positions(); }) == TS_E_NULL);
}

void notations_and_names() {
  CHECK(toothseg::fdi_to_universal(16) == 3 && toothseg::universal_to_fdi(3) == 16);
  CHECK(std::strcmp(toothseg::fdi_to_palmer(16).letters, "UR6") == 0);
  CHECK(status_thrown([] { toothseg::fdi_to_universal(19); }) == TS_E_INVALID_ARGUMENT);
  CHECK(status_thrown([] { toothseg::universal_to_fdi(33); }) == TS_E_INVALID_ARGUMENT);
  CHECK(status_thrown([] { toothseg::fdi_to_palmer(0); }) == TS_E_INVALID_ARGUMENT);
  const std::string version = std::to_string(TS_VERSION_MAJOR) + "." + std::to_string(TS_VERSION_MINOR) + ".";
  CHECK(std::string(toothseg::version()).find(version) == 0);
  CHECK(std::strcmp(toothseg::Exception(TS_E_NO_TEETH, "").name(), "TS_E_NO_TEETH") == 0);
}

}  // namespace

int main() {
  RUN(the_whole_way);
  RUN(failures_are_exceptions);
  RUN(owners_move);
  RUN(jobs);
  RUN(threads_of_the_host);
  RUN(corrections);
  RUN(cuts_are_edited);
  RUN(steps_are_taken_back);
  RUN(changes_are_told);
  RUN(sessions_are_resumed);
  RUN(meshes_are_made_and_written);
  RUN(notations_and_names);
  return harness_finish();
}
