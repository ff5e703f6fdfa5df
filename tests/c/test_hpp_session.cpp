// The C++ layer of corrections, sessions and meshes. SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "hpp_fixture.h"

namespace {

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

  toothseg::Point lower = s.on(tooth);
  for (std::size_t k = 0; k < 3; ++k) lower[k] -= 1.5 * s.features.occlusal()[k];
  segmentation.move_point(tooth, s.on(tooth), lower);
  CHECK(status_thrown([&] { segmentation.move_point(tooth, s.on(tooth), lower); }) == TS_E_NO_CHANGE);
  CHECK(segmentation.changes() == std::vector<toothseg::Index>{tooth});
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

}  // namespace

int main() {
  RUN(corrections);
  RUN(cuts_are_edited);
  RUN(steps_are_taken_back);
  RUN(changes_are_told);
  RUN(sessions_are_resumed);
  RUN(meshes_are_made_and_written);
  return harness_finish();
}
