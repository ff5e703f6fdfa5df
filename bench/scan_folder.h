// Reads a folder of the private scans (mesh.ply, face_labels.txt) for experiments inside the rooms.
#pragma once

#include <string>

#include "mesh/surface.h"

namespace ts::bench {

struct ScanFolder {
  std::string name;
  mesh::Surface surface;  // as intake makes it of mesh.ply
  Vec<int> label;         // a face of it; empty where the scan has none
};

ScanFolder read_scan_folder(const std::string &folder);  // throws std::runtime_error

}  // namespace ts::bench
