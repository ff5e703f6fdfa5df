// Export all teeth: export_teeth SCAN DIR writes a closed STL a tooth, named by its FDI number, the gingiva, and the
// whole scan with a node a tooth as GLB, into DIR. SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <exception>
#include <toothseg.hpp>

namespace ts = toothseg;

// Watertight, as printers and CAD want it. Where a rim cannot be closed the tooth is given open, and that is said.
static ts::Mesh crown(const ts::Segmentation &segmentation, ts::Index tooth) {
  ts_tooth_mesh_options options = ts::tooth_mesh_options();
  options.closed = 1;
  try {
    return ts::Mesh::tooth(segmentation, tooth, options);
  } catch (const ts::Exception &e) {
    if (e.status() != TS_E_NOT_CLOSED) throw;
    std::printf("left open: %s\n", e.what());
    return ts::Mesh::tooth(segmentation, tooth);
  }
}

static void export_teeth(const char *scan, const std::string &folder) {
  const ts::Context context;
  ts::Segmentation segmentation(ts::Features::detect(ts::Model::load(context, scan)));
  segmentation.segment_all();
  segmentation.assign_numbers();

  for (const ts::Index tooth : segmentation.teeth()) {
    // A number that is uncertain is shown to a person before it is used.
    const ts_number_info number = segmentation.number(tooth);
    const ts::Mesh mesh = crown(segmentation, tooth);
    const std::string path = folder + "/tooth_" + std::to_string(number.fdi) + ".stl";
    mesh.save(path, TS_OUTPUT_STL);

    // The same as arrays: mesh.positions(), .normals(), .triangles(); and the axes of the tooth, to lay it out by.
    const ts_tooth_frame frame = segmentation.tooth_frame(tooth);
    std::printf("%s%s: %u triangles, %.1f mm^3, %.1f mm wide\n", path.c_str(), number.uncertain ? " (uncertain)" : "",
                mesh.info().triangles, mesh.info().volume, frame.width);
  }
  ts::Mesh::gingiva(segmentation).save(folder + "/gingiva.stl", TS_OUTPUT_STL);
  segmentation.save(folder + "/scan.glb", TS_OUTPUT_GLB);
  std::printf("%zu teeth, gingiva.stl and scan.glb\n", segmentation.teeth().size());
}

int main(int argc, char **argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: export_teeth SCAN DIR\n"), 2;
  try {
    export_teeth(argv[1], argv[2]);
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "export_teeth: %s\n", e.what()), 1;
  }
}
