// The C++ layer says what the C functions say. SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <stdexcept>
#include <thread>

#include "hpp_fixture.h"

namespace {

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
  RUN(notations_and_names);
  return harness_finish();
}
