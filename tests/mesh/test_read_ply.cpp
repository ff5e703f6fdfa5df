#include "files.h"
#include "shapes.h"

using namespace shapes;
using namespace files;
using ts::Fault;

namespace {

const std::string ascii_header =
    "ply\nformat ascii 1.0\ncomment made by hand\nobj_info x\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";

// Properties and elements of every kind around those that are read.
std::string everything(const std::string &coding, bool big) {
  std::string s = "ply\nformat " + coding +
                  " 1.0\nelement camera 1\nproperty double fov\nproperty list ushort short names\n"
                  "element vertex 3\nproperty uchar red\nproperty double z\nproperty list uint8 float32 weights\n"
                  "property float x\nproperty short y\nelement face 2\nproperty uchar flags\n"
                  "property list int uint vertex_index\nproperty list uchar float texcoord\nelement tail 2\n"
                  "property int8 a\nend_header\n";
  s += raw(1.5, big) + raw(std::uint16_t{2}, big) + raw(std::int16_t{-1}, big) + raw(std::int16_t{7}, big);
  for (int v = 0; v < 3; ++v) {
    s += raw(std::uint8_t(9)) + raw(0.25 * v, big) + raw(static_cast<std::uint8_t>(v));
    for (int i = 0; i < v; ++i) s += raw(3.f, big);
    s += raw(static_cast<float>(v) + 0.5f, big) + raw(static_cast<std::int16_t>(-300 * v), big);
  }
  for (int f = 0; f < 2; ++f) {
    s += raw(std::uint8_t(f)) + raw(std::int32_t{3}, big);
    for (const std::uint32_t v : {0u, 1u, 2u}) s += raw(v, big);
    s += raw(std::uint8_t{6});
    for (int i = 0; i < 6; ++i) s += raw(0.f, big);
  }
  return s + "ab";
}

std::string two_triangles() {
  std::string s =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
      "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";
  for (int i = 0; i < 12; ++i) s += raw(static_cast<float>(i));
  for (const int f : {0, 1}) s += raw(std::uint8_t{3}) + raw(f) + raw(f + 1) + raw(f + 2);
  return s;
}

}  // namespace

TEST_CASE("ASCII PLY") {
  const RawMesh m = read(ascii_header + "0 0 0\n1 0 0\n1 1 .5\n0 1e0 -0\n3 0 1 2\n4 0 1 2 3\n");
  CHECK(m.position.size() == 4);
  CHECK(m.position[2] == Vec3(1, 1, 0.5));
  CHECK(m.faces() == 2);
  CHECK(m.face(0).size() == 3);
  CHECK(m.face(1).size() == 4);
  CHECK(m.face(1)[3] == 3);
}

TEST_CASE("PLY with line ends of Windows, ASCII and binary") {
  std::string text = ascii_header + "0 0 0\n1 0 0\n1 1 .5\n0 1 0\n3 0 1 2\n3 0 2 3", windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(read(windows).faces() == 2);
  std::string binary = two_triangles();
  const std::size_t end = binary.find("end_header\n") + 10;
  windows.clear();
  for (const char c : binary.substr(0, end + 1)) windows += c == '\n' ? "\r\n" : std::string(1, c);
  CHECK(read(windows + binary.substr(end + 1)).position == read(binary).position);
}

TEST_CASE("binary PLY of either byte order, with all kinds of properties and elements") {
  for (const bool big : {false, true}) {
    const std::string file = everything(big ? "binary_big_endian" : "binary_little_endian", big);
    const RawMesh m = read(file);
    REQUIRE(m.position.size() == 3);
    CHECK(m.position[2] == Vec3(2.5, -600, 0.5));
    REQUIRE(m.faces() == 2);
    CHECK(m.face(1)[2] == 2);
    CHECK(read(file + std::string(5, '\0')).faces() == 2);
    check_fault(Fault::file_trailing, "byte " + std::to_string(file.size()), [&] { read(file + "x"); });
    const std::size_t header = file.find("end_header\n") + 11;
    for (std::size_t size = header; size < file.size(); ++size)
      check_fault(Fault::file_truncated, "", [&] { read(file.substr(0, size)); });
    for (std::size_t size = 4; size + 1 < header; ++size) CHECK_THROWS_AS(read(file.substr(0, size)), ts::Error);
  }
}

TEST_CASE("PLY counts against the size of the file") {
  const auto with = [](const std::string &what, const std::string &count) {
    std::string s = two_triangles();
    return s.replace(s.find(what) + what.size(), 1, count);
  };
  check_fault(Fault::file_count, "promises 2000000000 vertex", [&] { read(with("element vertex ", "2000000000")); });
  check_fault(Fault::file_count, "promises 4000000000000 face", [&] { read(with("element face ", "4000000000000")); });
  check_fault(Fault::file_count, "negative", [&] { read(with("element face ", "-1")); });
  check_fault(Fault::file_truncated, "promises 100 vertex", [&] { read(with("element vertex ", "100")); });
  check_fault(Fault::file_syntax, "line 3", [&] { read(with("element vertex ", "99999999999999999999")); });
  check_fault(Fault::file_trailing, "", [&] { read(with("element face ", "1")); });
  std::string long_list = two_triangles();
  long_list[long_list.size() - 13] = char(200);
  check_fault(Fault::file_truncated, "a list of 200", [&] { read(long_list); });
  check_fault(Fault::file_count, "promises 2000000000", [] {
    read(
        "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\nproperty float "
        "z\nend_header\n");
  });
  // Elements without properties take no room: a great many are no work.
  CHECK(read("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
             "element nothing 1000000000\nend_header\n")
            .faces() == 0);
}

TEST_CASE("ASCII PLY that is wrong says where") {
  check_fault(Fault::file_syntax, "line 14: expected a number, found '1,5'", [] {
    read(ascii_header +
         "0 0 0\n1 0 0\n1,5 1 1\n"
         "0 0 0\n3 0 1 2\n3 0 1 2\n");
  });
  check_fault(Fault::file_syntax, "expected an integer, found '1.5'",
              [] { read(ascii_header + "0 0 0\n1 0 0\n1 1 1\n0 0 0\n3 0 1.5 2\n3 0 1 2\n"); });
  check_fault(Fault::file_truncated, "line 18",
              [] { read(ascii_header + "0 0 0\n1 0 0\n1 1 1\n0 0 0\n3 0 1 2\n3 0 1\n"); });
  check_fault(Fault::file_trailing, "line 18",
              [] { read(ascii_header + "0 0 0\n1 0 0\n1 1 1\n0 0 0\n3 0 1 2\n3 0 1 2\n5\n"); });
  check_fault(Fault::mesh_index_range, "face 1 names vertex -1",
              [] { read(ascii_header + "0 0 0\n1 0 0\n1 1 1\n0 0 0\n3 0 1 2\n3 0 1 -1\n"); });
}

TEST_CASE("PLY headers that are not read") {
  const auto with = [](const std::string &from, const std::string &to) {
    std::string s = ascii_header;
    return s.replace(s.find(from), from.size(), to) + "0 0 0\n1 0 0\n1 1 1\n0 0 0\n3 0 1 2\n3 0 1 2\n";
  };
  check_fault(Fault::file_syntax, "line 2", [&] { read(with("ascii", "morse")); });
  check_fault(Fault::file_syntax, "line 6: expected a PLY type, found 'quad'",
              [&] { read(with("float x", "quad x")); });
  check_fault(Fault::file_format, "no property x", [&] { read(with("float x", "float u")); });
  check_fault(Fault::file_format, "no element 'vertex'", [&] { read(with("element vertex", "element dots")); });
  check_fault(Fault::file_format, "vertex_indices", [&] { read(with("vertex_indices", "corners")); });
  check_fault(Fault::file_format, "not an integer", [&] { read(with("list uchar", "list float")); });
  check_fault(Fault::file_syntax, "no 'format' line", [&] { read(with("format ascii 1.0\n", "")); });
  check_fault(Fault::file_format, "strips", [&] { read(with("element face", "element tristrips")); });
}
