#include "mesh/write_glb.h"

#include <cmath>

#include "base/error.h"
#include "base/stop.h"
#include "mesh/decimal.h"

namespace ts::mesh {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2, kJson = 0x4E4F534A, kBinary = 0x004E4942;

// The vertices and triangles of one group, numbered for themselves.
struct Piece {
  Vec<Vec3> position, normal;
  Vec<Triangle> triangle;
};

Vec<Piece> pieces_of(const OutputMesh &mesh) {
  Vec<Piece> pieces(mesh.group.size());
  Vec<Index> place(mesh.position.size(), none), group(mesh.position.size(), none);
  StopNowAndThen stop(1 << 16);
  for (Index g = 0; g < pieces.size(); ++g) {
    Piece &piece = pieces[g];
    for (std::size_t i = 0; i < mesh.triangle.size(); ++i) {
      stop();
      if ((mesh.group_of.empty() ? 0 : mesh.group_of[i]) != g) continue;
      Triangle t = mesh.triangle[i];
      for (Index &v : t) {
        if (group[v] != g) {
          group[v] = g;
          place[v] = static_cast<Index>(piece.position.size());
          piece.position.push_back(mesh.position[v]);
        }
        v = place[v];
      }
      piece.triangle.push_back(t);
    }
    piece.normal.assign(piece.position.size(), Vec3::Zero());
    for (const auto &[a, b, c] : piece.triangle) {
      stop();
      const Vec3 &p = piece.position[a];
      const Vec3 n = (piece.position[b] - p).cross(piece.position[c] - p);
      for (const Index v : {a, b, c}) piece.normal[v] += n;
    }
    for (Vec3 &n : piece.normal) n = n.norm() > 0 ? Vec3(n.normalized()) : Vec3::UnitZ();  // it has to be a unit vector
  }
  return pieces;
}

// (Adding up literals and strings makes GCC 12 warn of overlapping copies: GCC bug 105651.)
std::string join(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts) text.append(part);
  return text;
}

std::string vector(const Eigen::Vector3f &v) {
  return join({"[", decimal(v[0]), ",", decimal(v[1]), ",", decimal(v[2]), "]"});
}

// The parts of the JSON that grow with the groups.
struct Lists {
  std::string nodes, meshes, materials, accessors, views;
  std::size_t groups = 0, bytes = 0;

  void add(const OutputGroup &group, const Piece &piece) {
    const auto text = [](std::size_t n) { return std::to_string(n); };
    const std::string comma = groups ? "," : "", a = text(3 * groups), b = text(3 * groups + 1),
                      c = text(3 * groups + 2);
    Eigen::Vector3f low = piece.position[0].cast<float>(), high = low;
    for (const Vec3 &p : piece.position) low = low.cwiseMin(p.cast<float>()), high = high.cwiseMax(p.cast<float>());
    nodes += join({",{\"name\":\"", group.name, "\",\"mesh\":", text(groups), "}"});
    meshes += join({comma, "{\"name\":\"", group.name, "\",\"primitives\":[{\"attributes\":{\"POSITION\":", a,
                    ",\"NORMAL\":", b, "},\"indices\":", c, ",\"material\":", text(groups),
                    "}],\"extras\":{\"label\":", text(group.label), "}}"});
    std::string colour;  // colours are sRGB, factors linear
    for (const std::uint8_t level : group.colour) colour += join({decimal(std::pow(level / 255.0, 2.2)), ","});
    materials += join({comma, "{\"name\":\"", group.name, "\",\"pbrMetallicRoughness\":{\"baseColorFactor\":[", colour,
                       "1],\"metallicFactor\":0,\"roughnessFactor\":0.6}}"});
    const auto view = [&](std::size_t size, const char *target) {
      views += join({views.empty() ? "" : ",", "{\"buffer\":0,\"byteOffset\":", text(bytes),
                     ",\"byteLength\":", text(size), ",\"target\":", target, "}"});
      bytes += size;
    };
    view(12 * piece.position.size(), "34962");
    view(12 * piece.position.size(), "34962");
    view(12 * piece.triangle.size(), "34963");
    const std::string floats =
        join({",\"componentType\":5126,\"count\":", text(piece.position.size()), ",\"type\":\"VEC3\""});
    accessors += join({comma, "{\"bufferView\":", a, floats, ",\"min\":", vector(low), ",\"max\":", vector(high),
                       "},{\"bufferView\":", b, floats, "},{\"bufferView\":", c,
                       ",\"componentType\":5125,\"count\":", text(3 * piece.triangle.size()), ",\"type\":\"SCALAR\"}"});
    ++groups;
  }

  // The first node is the scan, which turns mm to m.
  std::string json() const {
    std::string children;
    for (std::size_t g = 1; g <= groups; ++g) children += join({g > 1 ? "," : "", std::to_string(g)});
    return join(
        {"{\"asset\":{\"version\":\"2.0\",\"generator\":\"toothseg\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],",
         "\"nodes\":[{\"name\":\"scan\",\"scale\":[0.001,0.001,0.001],\"children\":[", children, "]}", nodes,
         "],\"meshes\":[", meshes, "],\"materials\":[", materials, "],\"accessors\":[", accessors,
         "],\"bufferViews\":[", views, "],\"buffers\":[{\"byteLength\":", std::to_string(bytes), "}]}"});
  }
};

}  // namespace

void write_glb(OutputFile &out, const OutputMesh &mesh) {
  const Vec<Piece> pieces = pieces_of(mesh);
  Lists lists;
  for (std::size_t g = 0; g < pieces.size(); ++g)
    if (!pieces[g].triangle.empty()) lists.add(mesh.group[g], pieces[g]);
  std::string json = lists.json();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::uint64_t size = 12 + 8 + json.size() + 8 + std::uint64_t{lists.bytes};
  if (size > UINT32_MAX) throw Error(Fault::file_write, "a mesh of this size does not fit into binary glTF");
  out.put(kMagic);
  out.put(kVersion);
  out.put(static_cast<std::uint32_t>(size));
  out.put(static_cast<std::uint32_t>(json.size()));
  out.put(kJson);
  out.write(json);
  out.put(static_cast<std::uint32_t>(lists.bytes));
  out.put(kBinary);
  for (const Piece &piece : pieces) {
    for (const Vec<Vec3> *values : {&piece.position, &piece.normal})
      for (const Vec3 &v : *values)
        for (int k = 0; k < 3; ++k) out.put(static_cast<float>(v[k]));
    for (const Triangle &t : piece.triangle)
      for (const Index v : t) out.put(v);
  }
}

}  // namespace ts::mesh
