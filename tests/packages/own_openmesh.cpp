// A host with an OpenMesh of its own, in one program with toothseg: it keeps the scan in OpenMesh, hands it over, and
// keeps the labels as a property. SPDX-License-Identifier: Apache-2.0
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cstdio>
#include <exception>
#include <toothseg.hpp>

#include "consumer/made_arch.hpp"
#include "consumer/summary.h"

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

int main() {
  try {
    const MadeArch arch;
    Mesh mesh;
    for (std::size_t i = 0; i < arch.positions.size(); i += 3)
      mesh.add_vertex({arch.positions[i], arch.positions[i + 1], arch.positions[i + 2]});
    for (std::size_t i = 0; i < arch.triangles.size(); i += 3) {
      const auto corner = [&](std::size_t k) { return mesh.vertex_handle(arch.triangles[i + k]); };
      if (!mesh.add_face(corner(0), corner(1), corner(2)).is_valid())
        throw std::runtime_error("OpenMesh refuses a face");
    }

    std::vector<double> positions;
    std::vector<std::uint32_t> triangles;
    for (const auto vertex : mesh.vertices())
      for (const double x : mesh.point(vertex)) positions.push_back(x);
    for (const auto face : mesh.faces())
      for (const auto vertex : face.vertices()) triangles.push_back(static_cast<std::uint32_t>(vertex.idx()));
    const toothseg::Context context;
    const toothseg::Model model(context, toothseg::mesh_input(positions, triangles));
    toothseg::Segmentation segmentation(toothseg::Features::detect(model));
    segmentation.click(segmentation.propose_clicks().at(0));

    OpenMesh::FPropHandleT<std::uint32_t> label;
    mesh.add_property(label, "label");
    const auto labels = segmentation.labels();
    for (const auto face : mesh.faces()) mesh.property(label, face) = labels.at(static_cast<std::size_t>(face.idx()));
    print_summary(mesh.property(label).data(), static_cast<std::uint32_t>(mesh.n_faces()));
    return 0;
  } catch (const std::exception &e) {
    return std::fprintf(stderr, "own_openmesh: %s\n", e.what()), 1;
  }
}
