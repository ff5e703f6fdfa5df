// ts-decimate: a mesh with fewer faces, by quadric error (OpenMesh's decimater), and its labels: each new face takes
// what most of 16 places spread over it are nearest to on the old surface.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/bench_pipeline.h"
#include "bench/bench_scan.h"

namespace {

using namespace ts::bench;

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

TriMesh half_edges(const Mesh &mesh) {
  TriMesh out;
  std::vector<TriMesh::VertexHandle> vertex;
  vertex.reserve(mesh.vertices());
  for (std::size_t v = 0; v < mesh.xyz.size(); v += 3)
    vertex.push_back(out.add_vertex({mesh.xyz[v], mesh.xyz[v + 1], mesh.xyz[v + 2]}));
  for (std::size_t f = 0; f < mesh.triangles.size(); f += 3)
    if (!out.add_face(vertex[mesh.triangles[f]], vertex[mesh.triangles[f + 1]], vertex[mesh.triangles[f + 2]])
             .is_valid())
      throw std::runtime_error("the mesh is not manifold at face " + std::to_string(f / 3));
  return out;
}

Mesh decimated(const Mesh &mesh, std::size_t faces) {
  TriMesh work = half_edges(mesh);
  OpenMesh::Decimater::DecimaterT<TriMesh> decimater(work);
  OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  if (!decimater.initialize()) throw std::runtime_error("the decimater could not begin");
  decimater.decimate_to_faces(0, faces);
  work.garbage_collection();
  Mesh out;
  for (const auto v : work.vertices())
    for (const double x : work.point(v)) out.xyz.push_back(static_cast<float>(x));
  for (const auto f : work.faces())
    for (const auto v : work.fv_range(f)) out.triangles.push_back(static_cast<std::uint32_t>(v.idx()));
  return out;
}

// A model whose faces know what they were: intake may drop some.
class Labelled {
 public:
  Labelled(const Mesh &mesh, std::vector<int> labels) : scan_(take_in(mesh, 0)), labels_(std::move(labels)) {
    const ts_model *const model = scan_.model.get();
    std::uint32_t count = 0;
    need_ok(ts_model_get_face_sources(model, nullptr, 0, &count), "ts_model_get_face_sources");
    source_.resize(count);
    need_ok(ts_model_get_face_sources(model, source_.data(), count, &count), "ts_model_get_face_sources");
  }

  int at(const std::array<double, 3> &place) const {
    ts_surface_point nearest;
    need_ok(ts_model_nearest(scan_.model.get(), place.data(), &nearest), "ts_model_nearest");
    return labels_[source_[nearest.face]];
  }

 private:
  Pipeline scan_;
  std::vector<std::uint32_t> source_;
  std::vector<int> labels_;
};

int most_of(const Mesh &mesh, std::size_t face, const Labelled &old) {
  std::map<int, int> votes;  // of equals the smallest label wins: the same on every machine
  constexpr int n = 4;       // the middles of n * n like parts
  const auto vote = [&](double a, double b) {
    std::array<double, 3> place{};
    const double weight[3] = {a, b, 1 - a - b};
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t c = 0; c < 3; ++c) place[c] += weight[k] * mesh.xyz[3 * mesh.triangles[3 * face + k] + c];
    ++votes[old.at(place)];
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      vote((i + 1. / 3) / n, (j + 1. / 3) / n);
      if (i + j + 1 < n) vote((i + 2. / 3) / n, (j + 2. / 3) / n);
    }
  int best = 0, most = 0;
  for (const auto &[label, count] : votes)
    if (count > most) best = label, most = count;
  return best;
}

std::vector<int> read_labels(const std::string &path, std::size_t faces) {
  std::ifstream in(path);
  std::vector<int> labels;
  for (int label; in >> label;) labels.push_back(label);
  if (labels.size() != faces)
    throw std::runtime_error(path + " has " + std::to_string(labels.size()) + " labels, the mesh " +
                             std::to_string(faces) + " faces");
  return labels;
}

}  // namespace

int main(int argc, char **argv) {
  std::string labels, out_labels;
  std::vector<std::string> plain;
  for (int i = 1; i < argc; ++i) {
    const std::string name = argv[i];
    if ((name == "--labels" || name == "--out-labels") && i + 1 < argc)
      (name == "--labels" ? labels : out_labels) = argv[++i];
    else
      plain.push_back(name);
  }
  const unsigned long wanted = plain.size() == 3 ? std::strtoul(plain[1].c_str(), nullptr, 10) : 0;
  if (wanted < 4 || labels.empty() != out_labels.empty()) {
    std::fprintf(stderr, "usage: ts-decimate IN.ply FACES OUT.ply [--labels IN.txt --out-labels OUT.txt]\n");
    return 2;
  }
  try {
    const Mesh mesh = read_mesh(plain[0]);
    const Mesh fewer = decimated(mesh, wanted);
    write_mesh(fewer, plain[2]);
    if (!labels.empty()) {
      const Labelled old(mesh, read_labels(labels, mesh.faces()));
      std::ofstream out(out_labels);
      for (std::size_t f = 0; f < fewer.faces(); ++f) out << most_of(fewer, f, old) << '\n';
      if (!out.flush()) throw std::runtime_error("cannot write " + out_labels);
    }
    std::printf("%s: %u vertices, %u triangles\n", plain[2].c_str(), fewer.vertices(), fewer.faces());
    return 0;
  } catch (const std::exception &e) {
    std::fprintf(stderr, "ts-decimate: %s\n", e.what());
    return 1;
  }
}
