#include "bench/scan_folder.h"

#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace ts::bench {

ScanFolder read_scan_folder(const std::string &folder) {
  std::ifstream in(folder + "/mesh.ply", std::ios::binary);
  if (!in) throw std::runtime_error("no mesh.ply in " + folder);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
  }
  Vec<mesh::Vec3> position(vertices);
  for (mesh::Vec3 &p : position) {
    float xyz[3];
    in.read(reinterpret_cast<char *>(xyz), sizeof xyz);
    p = {xyz[0], xyz[1], xyz[2]};
  }
  Vec<mesh::Triangle> triangle(faces);
  for (mesh::Triangle &t : triangle) {
    in.get();
    in.read(reinterpret_cast<char *>(t.data()), sizeof t);
  }
  if (!in) throw std::runtime_error("mesh.ply is cut off in " + folder);
  ScanFolder scan;
  scan.name = folder.substr(folder.find_last_of('/') + 1);
  scan.surface = mesh::make_surface(std::move(position), std::move(triangle));
  std::ifstream labels(folder + "/face_labels.txt");
  scan.label.assign(std::istream_iterator<int>(labels), {});
  return scan;
}

}  // namespace ts::bench
