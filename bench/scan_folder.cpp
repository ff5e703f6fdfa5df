#include "bench/scan_folder.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "base/error.h"
#include "mesh/intake.h"
#include "mesh/read.h"

namespace ts::bench {

ScanFolder read_scan_folder(const std::string &folder) {
  ScanFolder scan;
  scan.name = folder.substr(folder.find_last_of('/') + 1);
  std::ifstream labels(folder + "/face_labels.txt");
  const Vec<int> of_file(std::istream_iterator<int>(labels), {});
  try {
    mesh::Model model = mesh::make_model(mesh::load_mesh(folder + "/mesh.ply", {}), {}, Executor(1), {});
    for (const mesh::Index source : model.face_source)
      if (!of_file.empty()) scan.label.push_back(of_file.at(source));
    scan.surface = std::move(model.surface);
  } catch (const Error &e) {
    throw std::runtime_error(folder + ": " + e.what());
  }
  return scan;
}

}  // namespace ts::bench
