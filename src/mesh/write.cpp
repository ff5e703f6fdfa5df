#include "mesh/write.h"

#include "base/output_file.h"
#include "mesh/decimal.h"
#include "mesh/write_glb.h"

namespace ts::mesh {
namespace {

void put(OutputFile &out, const Vec3 &v) {
  for (int k = 0; k < 3; ++k) out.put(static_cast<float>(v[k]));
}

Index group_of(const OutputMesh &mesh, std::size_t triangle) {
  return mesh.group_of.empty() ? 0 : mesh.group_of[triangle];
}

void write_stl(OutputFile &out, const OutputMesh &mesh) {
  std::string header = "toothseg, mm";  // must not begin with "solid"
  header.resize(80, ' ');
  out.write(header);
  out.put(static_cast<std::uint32_t>(mesh.triangle.size()));
  for (const auto &[a, b, c] : mesh.triangle) {
    const Vec3 &p = mesh.position[a];
    const Vec3 n = (mesh.position[b] - p).cross(mesh.position[c] - p);
    put(out, n.norm() > 0 ? Vec3(n.normalized()) : Vec3(0, 0, 0));
    for (const Index v : {a, b, c}) put(out, mesh.position[v]);
    out.write(std::string_view("\0\0", 2));
  }
}

void write_ply(OutputFile &out, const OutputMesh &mesh) {
  out.write("ply\nformat binary_little_endian 1.0\ncomment toothseg, mm\n");
  for (const OutputGroup &g : mesh.group) out.write("comment label " + std::to_string(g.label) + " " + g.name + "\n");
  out.write("element vertex " + std::to_string(mesh.position.size()) +
            "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
            std::to_string(mesh.triangle.size()) +
            "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
            "property uchar blue\nproperty int label\nend_header\n");
  for (const Vec3 &p : mesh.position) put(out, p);
  for (std::size_t i = 0; i < mesh.triangle.size(); ++i) {
    const OutputGroup &g = mesh.group[group_of(mesh, i)];
    out.write("\x03");
    for (const Index v : mesh.triangle[i]) out.put(v);
    for (const std::uint8_t c : g.colour) out.write({reinterpret_cast<const char *>(&c), 1});
    out.put(g.label);
  }
}

void write_obj(OutputFile &out, const OutputMesh &mesh) {
  std::string line;  // one for all: it keeps its memory
  const auto print = [&](const char *kind, const auto &...values) {
    line.clear();
    line.append(kind);
    (line.append(" ").append(values), ...);
    line.append("\n");
    out.write(line);
  };
  out.write("# toothseg, mm\n");
  for (const Vec3 &p : mesh.position) print("v", decimal(p.x()), decimal(p.y()), decimal(p.z()));
  for (Index g = 0; g < mesh.group.size(); ++g) {
    out.write("g " + mesh.group[g].name + "\n");
    for (std::size_t i = 0; i < mesh.triangle.size(); ++i)
      if (const auto &[a, b, c] = mesh.triangle[i]; group_of(mesh, i) == g)
        print("f", std::to_string(a + 1), std::to_string(b + 1), std::to_string(c + 1));
  }
}

}  // namespace

void save_mesh(const std::string &path, OutputFormat format, const OutputMesh &mesh, const Progress &progress) {
  progress(0);
  OutputFile out(path);
  switch (format) {
    case OutputFormat::stl: write_stl(out, mesh); break;
    case OutputFormat::ply: write_ply(out, mesh); break;
    case OutputFormat::obj: write_obj(out, mesh); break;
    case OutputFormat::glb: write_glb(out, mesh); break;
  }
  progress(1);  // the last moment at which it can be cancelled
  out.commit();
}

}  // namespace ts::mesh
