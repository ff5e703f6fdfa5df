// SPDX-License-Identifier: Apache-2.0
#include "good_files.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>

#include "check.h"

namespace {

std::string format(const char *pattern, double x, double y, double z) {
  char text[128];
  std::snprintf(text, sizeof text, pattern, x, y, z);
  return text;
}

// make_bumps gives a square of the grid as two triangles, (a b c) and (a c d).
using Quad = std::array<std::uint32_t, 4>;
std::vector<Quad> quads_of(const Bumps &b) {
  std::vector<Quad> quads;
  for (std::size_t t = 0; t < b.triangles.size(); t += 6)
    quads.push_back({b.triangles[t], b.triangles[t + 1], b.triangles[t + 2], b.triangles[t + 5]});
  return quads;
}

std::string stl_text(const Bumps &b) {
  std::string s = "solid scan\n";
  for (std::size_t t = 0; t < b.triangles.size(); t += 3) {
    s += "  facet normal 0 0 1\n    outer loop\n";
    for (std::size_t k = 0; k < 3; ++k) {
      const double *p = &b.xyz[3 * b.triangles[t + k]];
      s += format("      vertex %.6e %.6e %.6e\n", p[0], p[1], p[2]);
    }
    s += "    endloop\n  endfacet\n";
  }
  return s + "endsolid scan\n";
}

std::string ply_header(const char *coding, std::size_t vertices, std::size_t faces) {
  return "ply\nformat " + std::string(coding) + " 1.0\ncomment of a test\nelement vertex " + std::to_string(vertices) +
         "\nproperty float x\nproperty double y\nproperty float z\nproperty uchar quality\nelement face " +
         std::to_string(faces) + "\nproperty list uchar int vertex_indices\nproperty short flags\nend_header\n";
}

std::string ply_text(const Bumps &b) {
  const auto quads = quads_of(b);
  std::string s = ply_header("ascii", b.xyz.size() / 3, quads.size());
  for (std::size_t v = 0; v < b.xyz.size(); v += 3)
    s += format("%.9g %.9g %.9g 7\n", b.xyz[v], b.xyz[v + 1], b.xyz[v + 2]);
  for (const Quad &q : quads) {
    s += "4";
    for (const std::uint32_t v : q) s += " " + std::to_string(v);
    s += " -1\n";
  }
  return s;
}

template <class T>
void append(std::string &s, T value, bool big) {
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big) std::reverse(bytes, bytes + sizeof value);
  s.append(bytes, sizeof value);
}

std::string ply_binary(const Bumps &b, bool big) {
  const auto quads = quads_of(b);
  std::string s = ply_header(big ? "binary_big_endian" : "binary_little_endian", b.xyz.size() / 3, quads.size());
  for (std::size_t v = 0; v < b.xyz.size(); v += 3) {
    append(s, static_cast<float>(b.xyz[v]), big);
    append(s, b.xyz[v + 1], big);
    append(s, static_cast<float>(b.xyz[v + 2]), big);
    append(s, std::uint8_t{7}, big);
  }
  for (const Quad &q : quads) {
    append(s, std::uint8_t{4}, big);
    for (const std::uint32_t v : q) append(s, static_cast<std::int32_t>(v), big);
    append(s, std::int16_t{-1}, big);
  }
  return s;
}

// Corners in all ways to write them, half of them counted back from the last vertex.
std::string obj_text(const Bumps &b) {
  std::string s = "# of a test\no scan\n";
  for (std::size_t v = 0; v < b.xyz.size(); v += 3)
    s += format("v %.9g %.9g %.9g\n", b.xyz[v], b.xyz[v + 1], b.xyz[v + 2]);
  s += "vn 0 0 1\nvt 0 0\ng faces\n";
  const auto vertices = static_cast<long>(b.xyz.size() / 3);
  bool back = false;
  for (const Quad &q : quads_of(b)) {
    s += "f";
    for (std::size_t k = 0; k < 4; ++k) {
      static const char *const more[] = {"", "/1/1", "//1", "/1"};
      s += " " + std::to_string(back ? static_cast<long>(q[k]) - vertices : static_cast<long>(q[k]) + 1) + more[k];
    }
    s += "\n";
    back = !back;
  }
  return s;
}

std::string off_text(const Bumps &b, bool colours) {
  const auto quads = quads_of(b);
  std::string s = (colours ? "COFF\n" : "OFF\n# of a test\n") + std::to_string(b.xyz.size() / 3) + " " +
                  std::to_string(quads.size()) + " 0\n";
  for (std::size_t v = 0; v < b.xyz.size(); v += 3)
    s += format(colours ? "%.9g %.9g %.9g 0.5 0.5 0.5 1\n" : "%.9g %.9g %.9g\n", b.xyz[v], b.xyz[v + 1], b.xyz[v + 2]);
  for (const Quad &q : quads) {
    s += "4";
    for (const std::uint32_t v : q) s += " " + std::to_string(v);
    s += colours ? " 255 0 0\n" : "\n";
  }
  return s;
}

std::string content_of(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// A session with a step of each kind that a small scene allows.
void steps(ts_segmentation *s, const Bumps &bumps) {
  HOLDS(ts_segment_click(s, bumps.top[0].data(), nullptr, nullptr) == TS_OK);
  HOLDS(ts_segment_all(s, nullptr) == TS_OK);
  const auto teeth = check::all<std::uint32_t>(
      [&](std::uint32_t *p, std::uint32_t n, std::uint32_t *c) { return ts_get_teeth(s, p, n, c); });
  HOLDS(teeth.size() == 3);
  const double beside[3] = {5, 1, 1};
  HOLDS(ts_tooth_include(s, teeth[0], beside, nullptr) == TS_OK);
  HOLDS(ts_cut_smooth(s, teeth[1], 0.4, nullptr) == TS_OK);
  HOLDS(ts_assign_numbers(s, nullptr) == TS_OK);
  HOLDS(ts_set_number(s, teeth[0], 33) == TS_OK);
  HOLDS(ts_tooth_set_locked(s, teeth[2], 1) == TS_OK);
  HOLDS(ts_undo(s) == TS_OK);
}

}  // namespace

Bumps session_bumps() {
  return make_bumps(3, 5, 5);
}

std::vector<GoodFile> good_files(const std::string &folder) {
  const Bumps b = make_bumps(2, 5, 5);
  const auto vertices = static_cast<std::uint32_t>(b.xyz.size() / 3),
             triangles = static_cast<std::uint32_t>(b.triangles.size() / 3), quads = triangles / 2;
  std::vector<GoodFile> files = {
      {"STL text", TS_FORMAT_STL, Coding::text, stl_text(b), 3 * triangles, triangles},
      {"PLY text", TS_FORMAT_PLY, Coding::text, ply_text(b), vertices, quads},
      {"PLY little endian", TS_FORMAT_PLY, Coding::little_endian, ply_binary(b, false), vertices, quads},
      {"PLY big endian", TS_FORMAT_PLY, Coding::big_endian, ply_binary(b, true), vertices, quads},
      {"OBJ", TS_FORMAT_OBJ, Coding::text, obj_text(b), vertices, quads},
      {"OFF", TS_FORMAT_OFF, Coding::text, off_text(b, false), vertices, quads},
      {"COFF", TS_FORMAT_OFF, Coding::text, off_text(b, true), vertices, quads},
  };
  const auto context = one_thread();
  const auto session_on = [](const ts_features *f) {
    auto s =
        made<ts_segmentation>([&](ts_segmentation **out) { return ts_segmentation_create(f, nullptr, nullptr, out); });
    HOLDS(s != nullptr);
    return s;
  };
  {
    const auto model = model_of(context.get(), b);
    const auto s = session_on(features_of(model.get(), b).get());
    ts_save_options whole;
    HOLDS(ts_save_options_init(&whole, sizeof whole) == TS_OK);
    whole.whole_faces = 1;
    const std::string path = folder + "/written";
    const auto written = [&](const char *name, ts_output_format as, ts_file_format format, Coding coding,
                             std::uint32_t given) {
      HOLDS(ts_segmentation_save(s.get(), path.c_str(), as, &whole, nullptr) == TS_OK);
      files.push_back({name, format, coding, content_of(path), given, triangles});
    };
    written("STL written", TS_OUTPUT_STL, TS_FORMAT_STL, Coding::little_endian, 3 * triangles);
    written("PLY written", TS_OUTPUT_PLY, TS_FORMAT_PLY, Coding::little_endian, vertices);
    written("OBJ written", TS_OUTPUT_OBJ, TS_FORMAT_OBJ, Coding::text, vertices);
  }
  const Bumps scene = session_bumps();
  const auto model = model_of(context.get(), scene);
  const auto s = session_on(features_of(model.get(), scene).get());
  steps(s.get(), scene);
  const auto text =
      check::all<char>([&](char *p, std::uint32_t n, std::uint32_t *c) { return ts_session_write(s.get(), p, n, c); });
  files.push_back({"session",
                   TS_FORMAT_AUTO,
                   Coding::text,
                   {text.begin(), text.end()},
                   static_cast<std::uint32_t>(scene.xyz.size() / 3),
                   static_cast<std::uint32_t>(scene.triangles.size() / 3)});
  return files;
}
