// A host that has everything already: the mesh in arrays of its own, its own memory, log and progress display, and a
// user who changes their mind. No file is read. SPDX-License-Identifier: Apache-2.0
#include <toothseg_arch.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <stdexcept>
#include <toothseg.hpp>
#include <vector>

namespace ts = toothseg;

// ---------------------------------------------------------------------------------------------------- the host's own

// Memory that is counted: what the library holds now, what it held at most. The hooks may be called from any thread.
struct Memory {
  std::atomic<std::size_t> now{0}, most{0}, blocks{0};

  // The size stands before each block, in as many bytes as keep what follows aligned to 16.
  static constexpr std::size_t head = 16;

  static void *take(std::size_t bytes, void *user) {
    Memory &m = *static_cast<Memory *>(user);
    void *block = std::malloc(bytes + head);
    if (block == nullptr) return nullptr;
    *static_cast<std::size_t *>(block) = bytes;
    const std::size_t now = m.now += bytes;
    for (std::size_t most = m.most; most < now && !m.most.compare_exchange_weak(most, now);) {
    }
    ++m.blocks;
    return static_cast<char *>(block) + head;
  }

  static void give(void *memory, void *user) {
    if (memory == nullptr) return;
    Memory &m = *static_cast<Memory *>(user);
    void *block = static_cast<char *>(memory) - head;
    m.now -= *static_cast<std::size_t *>(block);
    --m.blocks;
    std::free(block);
  }
};

static void write_log(ts_log_level level, const char *text, void *) {
  static const char *const names[] = {"error", "warning", "info"};
  std::printf("  log, %s: %s\n", level <= TS_LOG_INFO ? names[level] : "?", text);
}

struct Mesh {
  std::vector<float> xyz;
  std::vector<ts::Index> triangles;
};

static void need(int status) {
  if (status != TSA_OK) throw std::runtime_error(tsa_last_error_message());
}

static Mesh make_mesh() {
  tsa_options options;
  need(tsa_options_init(&options, sizeof options));
  options.triangles = 30000;
  tsa_arch *arch = nullptr;
  need(tsa_create(&options, &arch));
  Mesh mesh;
  std::uint32_t vertices = 0, faces = 0;
  int status = tsa_get_positions_f32(arch, nullptr, 0, &vertices);
  if (status == TSA_OK) status = tsa_get_triangles(arch, nullptr, 0, &faces);
  mesh.xyz.resize(3 * std::size_t{vertices});
  mesh.triangles.resize(3 * std::size_t{faces});
  if (status == TSA_OK) status = tsa_get_positions_f32(arch, mesh.xyz.data(), vertices, &vertices);
  if (status == TSA_OK) status = tsa_get_triangles(arch, mesh.triangles.data(), faces, &faces);
  tsa_destroy(arch);
  need(status);
  return mesh;
}

// --------------------------------------------------------------------------------------------------------- the work

// A user who cancels the preparation half way: nothing is left of it, and it can be asked for again.
static void change_of_mind(const ts::Context &context, const ts::Features &features) {
  ts::Job impatient(context, [](double fraction, const char *) { return fraction < 0.5; });
  try {
    const ts::Segmentation never(features, ts::segment_options(), &impatient);
    std::printf("done before it could be cancelled\n");
  } catch (const ts::Exception &e) {
    if (e.status() != TS_E_CANCELLED) throw;
    std::printf("cancelled at %.0f %%\n", 100 * impatient.progress());
  }
}

static void separate(const ts::Context &context, const ts::Model &model) {
  ts::Job job(context, [last = -1](double fraction, const char *stage) mutable {
    const int tenth = static_cast<int>(10 * fraction);
    if (tenth != last) std::printf("  %3d %% %s\n", 10 * tenth, stage);
    last = tenth;
    return true;
  });
  const ts::Features features = ts::Features::detect(model, ts::feature_options(), &job);
  std::printf("%zu feature points in %zu groups\n", features.points().size(), features.groups().size());
  change_of_mind(context, features);

  ts::Segmentation segmentation(features, ts::segment_options(), &job);
  // All clicks at once, with one beside the scan among them, which fails alone.
  std::vector<ts::Point> clicks = segmentation.propose_clicks();
  clicks.push_back({1000, 0, 0});
  const std::vector<ts_status> statuses = segmentation.clicks(clicks, &job);
  for (std::size_t i = 0; i < clicks.size(); ++i) std::printf("click %zu: %s\n", i, ts_status_name(statuses[i]));

  for (const ts::Index id : segmentation.teeth()) {
    const ts_tooth_info tooth = segmentation.tooth(id);
    const ts::Cut cut = segmentation.cut(id);
    std::printf("tooth %2u: %6u faces, %6.1f mm^2, cut of %4zu points and %5.1f mm\n", tooth.label, tooth.faces,
                tooth.area, cut.points.size(), cut.info.length);
  }
}

int main() {
  Memory memory;  // outlives every object of the context
  try {
    ts_context_options options = ts::context_options();
    options.alloc = Memory::take;
    options.free = Memory::give;
    options.alloc_user = &memory;
    options.log = write_log;
    const ts::Context context(options);

    Mesh mesh = make_mesh();
    const ts::Model model(context, ts::mesh_input(mesh.xyz, mesh.triangles));
    mesh = Mesh();  // the model has its own copy
    const ts_intake_report report = model.report();
    std::printf("%u vertices, %u faces, %u pieces, %u rims\n", report.vertices, report.faces, report.components,
                report.boundary_loops);
    separate(context, model);
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "own_arrays: %s\n", e.what()), 1;
  }
  std::printf("memory: at most %.1f MB, %zu blocks not given back\n", static_cast<double>(memory.most) / 1e6,
              memory.blocks.load());
  return memory.blocks == 0 ? 0 : 1;
}
