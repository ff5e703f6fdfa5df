// glTF 2.0 in one binary file (Khronos: glTF 2.0 Specification, 4.4 "Binary glTF Layout").
#pragma once

#include "base/output_file.h"
#include "mesh/write.h"

namespace ts::mesh {

void write_glb(OutputFile &out, const OutputMesh &mesh);

}  // namespace ts::mesh
