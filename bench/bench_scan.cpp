#include "bench/bench_scan.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <unordered_map>

#include "toothseg_arch.h"

namespace ts::bench {
namespace {

void check(int status) {
  if (status != TSA_OK) throw std::runtime_error(tsa_last_error_message());
}

Mesh make_directly(std::uint32_t wanted) {
  tsa_options options{};
  check(tsa_options_init(&options, sizeof options));
  options.jaw = TSA_JAW_LOWER;
  options.triangles = wanted;
  options.seed = 1;
  options.crowding = 0.35;
  tsa_arch *made = nullptr;
  check(tsa_create(&options, &made));
  const std::unique_ptr<tsa_arch, decltype(&tsa_destroy)> arch(made, tsa_destroy);
  std::uint32_t vertices = 0, faces = 0;
  check(tsa_get_positions_f32(made, nullptr, 0, &vertices));
  check(tsa_get_triangles(made, nullptr, 0, &faces));
  Mesh mesh;
  mesh.xyz.resize(3 * std::size_t{vertices});
  mesh.triangles.resize(3 * std::size_t{faces});
  check(tsa_get_positions_f32(made, mesh.xyz.data(), vertices, &vertices));
  check(tsa_get_triangles(made, mesh.triangles.data(), faces, &faces));
  return mesh;
}

// Four triangles for one, with the middles of the edges as new vertices.
Mesh halve_edges(const Mesh &coarse) {
  Mesh fine;
  fine.xyz = coarse.xyz;
  std::unordered_map<std::uint64_t, std::uint32_t> middles;
  middles.reserve(coarse.triangles.size() / 2);
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto [it, is_new] = middles.try_emplace(std::uint64_t{low} << 32 | high, fine.vertices());
    if (is_new)
      for (std::size_t k = 0; k < 3; ++k)
        fine.xyz.push_back((coarse.xyz[3 * std::size_t{low} + k] + coarse.xyz[3 * std::size_t{high} + k]) / 2);
    return it->second;
  };
  for (std::size_t t = 0; t < coarse.triangles.size(); t += 3) {
    const std::uint32_t a = coarse.triangles[t], b = coarse.triangles[t + 1], c = coarse.triangles[t + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    const std::uint32_t four[] = {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca};
    fine.triangles.insert(fine.triangles.end(), std::begin(four), std::end(four));
  }
  return fine;
}

}  // namespace

Mesh make_arch(std::uint32_t triangles) {
  return triangles > most_direct ? halve_edges(make_arch(triangles / 4)) : make_directly(triangles);
}

Mesh read_mesh(const std::string &path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error("cannot open " + path);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    if (line.starts_with("element vertex ")) vertices = std::stoul(line.substr(15));
    if (line.starts_with("element face ")) faces = std::stoul(line.substr(13));
  }
  Mesh mesh;
  mesh.xyz.resize(3 * vertices);
  mesh.triangles.resize(3 * faces);
  in.read(reinterpret_cast<char *>(mesh.xyz.data()), static_cast<std::streamsize>(mesh.xyz.size() * sizeof(float)));
  for (std::size_t f = 0; f < faces; ++f) {
    if (in.get() != 3) throw std::runtime_error(path + ": not a PLY of floats and triangles");
    in.read(reinterpret_cast<char *>(mesh.triangles.data() + 3 * f), 12);
  }
  if (!in) throw std::runtime_error(path + " is cut off");
  return mesh;
}

void write_mesh(const Mesh &mesh, const std::string &path) {
  std::ofstream out(path, std::ios::binary);
  out << "ply\nformat binary_little_endian 1.0\nelement vertex " << mesh.vertices()
      << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << mesh.faces()
      << "\nproperty list uchar int vertex_indices\nend_header\n";
  out.write(reinterpret_cast<const char *>(mesh.xyz.data()),
            static_cast<std::streamsize>(mesh.xyz.size() * sizeof(float)));
  for (std::size_t f = 0; f < mesh.faces(); ++f) {
    out.put(3);
    out.write(reinterpret_cast<const char *>(mesh.triangles.data() + 3 * f), 12);
  }
  if (!out) throw std::runtime_error("cannot write " + path);
}

std::vector<unsigned char> stl_of(const Mesh &mesh) {
  std::vector<unsigned char> bytes(84 + 50 * std::size_t{mesh.faces()}, 0);
  const std::uint32_t faces = mesh.faces();
  std::memcpy(bytes.data() + 80, &faces, 4);
  for (std::size_t f = 0; f < faces; ++f)
    for (std::size_t k = 0; k < 3; ++k)
      std::memcpy(bytes.data() + 84 + 50 * f + 12 + 12 * k,
                  mesh.xyz.data() + 3 * std::size_t{mesh.triangles[3 * f + k]}, 12);
  return bytes;
}

}  // namespace ts::bench
