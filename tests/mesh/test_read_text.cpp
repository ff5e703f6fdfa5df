// OBJ, OFF, telling the formats apart, and files on disk.
#include <filesystem>
#include <fstream>

#include "files.h"
#include "shapes.h"

using namespace shapes;
using namespace files;
using ts::Fault;

TEST_CASE("OBJ") {
  const RawMesh m = read(
      "# a comment\nmtllib x.mtl\no tooth\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0 .5 .5 .5\nvt 0 0\nvn 0 0 1\n  v\t0 1 \\\n "
      "2.5\n"
      "usemtl white\ns off\nf 1 2 3\nf 1/1 2/1 3/1 4/1 # quad\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 -1/1/1\nf -4 \\\r\n -3 "
      "-2\nl 1 2\np 1");
  CHECK(m.position.size() == 4);
  CHECK(m.position[3] == Vec3(0, 1, 2.5));
  REQUIRE(m.faces() == 5);
  CHECK(m.face(1).size() == 4);
  CHECK(m.face(3)[2] == 3);
  CHECK(m.face(4)[0] == 0);
  CHECK(m.face(4)[2] == 2);
}

TEST_CASE("OBJ that is wrong says where") {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  check_fault(Fault::file_syntax, "line 4: expected a vertex index, found 'x'", [&] { read(v + "f 1 2 x\n"); });
  check_fault(Fault::file_syntax, "line 4: expected another vertex index", [&] { read(v + "f 1 2\nf 1 2 3\n"); });
  check_fault(Fault::file_syntax, "line 2: expected a coordinate", [&] { read("v 0 0 0\nv 1 0\nv 0 1 0\n"); });
  check_fault(Fault::mesh_index_range, "line 5: there is no vertex 0", [&] { read(v + "f 1 2 3\nf 0 1 2\n"); });
  check_fault(Fault::mesh_index_range, "line 4: there is no vertex -4", [&] { read(v + "f -1 -2 -4\n"); });
  check_fault(Fault::mesh_index_range, "there is no vertex 99999999999", [&] { read(v + "f 1 2 99999999999\n"); });
  check_fault(Fault::mesh_index_range, "face 0 names vertex 6", [&] { model_of(read(v + "f 1 2 7\n")); });
  check_fault(Fault::file_truncated, "line 4", [&] { read(v + "f 1 2"); });
  check_fault(Fault::file_truncated, "line 3", [&] { read("v 0 0 0\nv 1 0 0\nv 0 1"); });
  check_fault(Fault::file_format, "no vertex", [&] { read("o nothing\n"); });
}

TEST_CASE("numbers at the ends of the range") {
  const RawMesh m = read("v 1e-400 1e400 -1e400\nv nan inf 0.1\n");
  CHECK(m.position[0] == Vec3(0, HUGE_VAL, m.position[0].z()));
  CHECK(std::isinf(m.position[0].z()));
  CHECK(std::isnan(m.position[1].x()));
  CHECK(m.position[1].z() == 0.1);
}

TEST_CASE("OFF and its variants") {
  const std::string body = "0 0 0\n1 0 0\n1 1 0.5\n0 1 0\n3 0 1 2\n4 0 1 2 3\n";
  for (const char *head :
       {"OFF\n4 2 0\n", "OFF 4 2 0\n", "# by hand\nOFF # yes\n\n# counts\n4 2 5\n\n", "OFF\r\n4 2 0\r\n"}) {
    const RawMesh m = read(head + body);
    CHECK(m.position.size() == 4);
    CHECK(m.position[2] == Vec3(1, 1, 0.5));
    REQUIRE(m.faces() == 2);
    CHECK(m.face(1)[3] == 3);
  }
  CHECK(read("COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 9 9 9 9\n3 0 1 2 0.5 0.5 0.5\n").faces() == 1);
  CHECK(read("STCNOFF\n3 1 0\n0 0 0 1 1 1 1 1\n1 0 0 1 1 1\n0 1 0 2 2 2\n3 0 1 2\n# end\n").faces() == 1);
}

TEST_CASE("OFF that is wrong says where") {
  const std::string v = "0 0 0\n1 0 0\n0 1 0\n";
  check_fault(Fault::file_format, "4OFF", [] { read("4OFF\n1 0 0\n0 0 0 0\n"); });
  check_fault(Fault::file_format, "binary OFF", [] { read("OFF BINARY\n" + std::string(8, '\0')); });
  check_fault(Fault::file_count, "promises 2000000000 vertices", [] { read("OFF\n2000000000 1 0\n"); });
  check_fault(Fault::file_count, "promises 2000000000 faces", [&] { read("OFF\n3 2000000000 0\n" + v); });
  check_fault(Fault::file_count, "corners of a face", [&] { read("OFF\n3 1 0\n" + v + "2000000000 0 1 2\n"); });
  check_fault(Fault::file_count, "negative", [&] { read("OFF\n-3 1 0\n" + v); });
  check_fault(Fault::file_truncated, "line 6", [&] { read("OFF\n3 2 0\n" + v + "3 0 1 2"); });
  check_fault(Fault::file_syntax, "line 6: expected a vertex index, found 'x'",
              [&] { read("OFF\n3 1 0\n" + v + "3 0 1 x\n"); });
  check_fault(Fault::file_syntax, "line 3: expected a coordinate, found the end of the line",
              [] { read("OFF\n3 1 0\n0 0\n1 0 0\n0 1 0\n3 0 1 2\n"); });
  check_fault(Fault::mesh_index_range, "no vertex -2", [&] { read("OFF\n3 1 0\n" + v + "3 0 1 -2\n"); });
  check_fault(Fault::file_trailing, "line 7", [&] { read("OFF\n3 1 0\n" + v + "3 0 1 2\n3 0 1 2\n"); });
}

TEST_CASE("control characters in comments make no STL of a text") {
  CHECK(read("# made by \x01 with \x02\nv 0 0 0\nv 1 0 0\nv 0 1 0\n# " + std::string(90, '\x03') + "\nf 1 2 3\n")
            .faces() == 1);
  CHECK(read("OFF\n# \x01\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").faces() == 1);
  check_fault(Fault::file_syntax, "line 2: expected", [] { read("v 0 0 0\nv 0 \x01 0\n"); });
}

TEST_CASE("what is no mesh file is refused") {
  for (const std::string &file :
       {std::string(), std::string("\n\n"), std::string("hello world\n"), std::string("<?xml version='1.0'?>"),
        std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(300, '\x01'),
        std::string("PK\x03\x04") + std::string(200, 'x')})
    check_fault(Fault::file_format, "", [&] { read(file); });
  check_fault(Fault::file_format, "not a PLY", [] { read("OFF\n1 0 0\n0 0 0\n", Format::ply); });
}

TEST_CASE("no file of random bytes or random changes does harm") {
  std::mt19937 random(11);
  const std::vector<std::string> good = {
      binary_stl(4, 4),
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n",
      "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
      "z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n" +
          std::string(36, '\x3f') + std::string("\x03\0\0\0\0\1\0\0\0\2\0\0\0", 13),
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n3\n",
      "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"};
  int read_well = 0;
  for (int i = 0; i < 6000; ++i) {
    std::string file = good[i % good.size()];
    for (unsigned k = random() % 4 + 1; k > 0; --k) {
      const std::size_t at = random() % file.size();
      if (random() % 3 == 0)
        file.erase(at, random() % 20 + 1);
      else
        file[at] = random() % 2 ? static_cast<char>(random()) : "0123456789-. \n\\"[random() % 15];
      if (file.empty()) file = "x";
    }
    for (const Format format : {Format::automatic, Format::stl, Format::ply, Format::obj, Format::off}) try {
        const RawMesh raw = read(file, format);
        ++read_well;
        check_promises(model_of(raw));
      } catch (const ts::Error &) {
      }
  }
  CHECK(read_well > 100);
}

TEST_CASE("long lines, many words and deep continuations take no more than their length") {
  std::string continued = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3";
  for (int i = 0; i < 200000; ++i) continued += " \\\n";
  CHECK(read(continued + "\n").faces() == 1);
  std::string blank(1000000, '\n');
  blank += "OFF\n0 0 0\n";
  CHECK(read(blank).faces() == 0);
  check_fault(Fault::file_syntax, "'111", [] { read("v 0 0 " + std::string(1000000, '1') + "x\n"); });
}

TEST_CASE("reading can be cancelled") {
  struct Stop : ts::Monitor {
    bool proceed(double, const char *) noexcept override { return false; }
  };
  Stop stop;
  for (const std::string &file : {binary_stl(2, 2), std::string("v 0 0 0\n"), std::string("OFF\n1 0 0\n0 0 0\n")})
    check_fault(Fault::cancelled, "reading", [&] { read_mesh(bytes(file), Format::automatic, ts::Progress(&stop)); });
}

TEST_CASE("files on disk, with any name") {
  const auto folder = std::filesystem::temp_directory_path() / "toothseg_test_mesh";
  std::filesystem::create_directories(folder);
  const std::u8string name = u8"zähne_歯.stl";
  std::ofstream(folder / name, std::ios::binary) << binary_stl(3, 3);
  const std::u8string path = (folder / name).u8string();
  CHECK(load_mesh(std::string(path.begin(), path.end())).faces() == 3);
  check_fault(Fault::file_open, "no such", [&] { load_mesh((folder / "no such file").string()); });
  check_fault(Fault::file_open, "directory", [&] { load_mesh(folder.string()); });
  std::filesystem::remove_all(folder);
}
