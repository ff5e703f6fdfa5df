#include "files.h"
#include "shapes.h"

using namespace shapes;
using namespace files;
using ts::Fault;

namespace {

std::string facet(const std::string &normal = "0 0 1") {
  return "  facet normal " + normal +
         "\n    outer loop\n      vertex 0 0 0\n      vertex 1.5 0 0\n      vertex 0 -2.5e-1 +3\n"
         "    endloop\n  endfacet\n";
}

}  // namespace

TEST_CASE("binary STL") {
  const RawMesh m = read(binary_stl(7, 7));
  CHECK(m.faces() == 7);
  CHECK(m.position.size() == 21);
  CHECK(m.position[3 * 6 + 1] == Vec3(7.5, 8, 8.5));
  CHECK(m.face(6)[2] == 20);
}

TEST_CASE("binary STL whose header begins like an ASCII one") {
  CHECK(read(binary_stl(3, 3, "solid made by some CAD")).faces() == 3);
  std::string blanks = "solid";
  blanks.resize(80, ' ');
  CHECK(read(binary_stl(3, 3, blanks)).faces() == 3);
  check_fault(Fault::file_truncated, "promises 30 triangles", [&] { read(binary_stl(30, 3, blanks)); });
}

TEST_CASE("binary STL cut off") {
  const std::string whole = binary_stl(100, 100);
  for (const std::size_t size : {84u, 85u, 133u, 134u, 2000u, 5083u})
    check_fault(Fault::file_truncated, "promises 100 triangles", [&] { read(whole.substr(0, size)); });
  check_fault(Fault::file_truncated, "at least 84 bytes", [&] { read(whole.substr(0, 83), Format::stl); });
}

TEST_CASE("binary STL with a count that cannot be") {
  check_fault(Fault::file_count, "promises 2000000000 triangles", [] { read(binary_stl(2000000000, 0)); });
  check_fault(Fault::file_count, "promises 2000000000 triangles", [] { read(binary_stl(2000000000, 100)); });
  check_fault(Fault::file_count, "promises 4294967295 triangles", [] { read(binary_stl(4294967295u, 5)); });
}

TEST_CASE("binary STL that goes on: padding is fine, anything else not") {
  CHECK(read(binary_stl(2, 2) + std::string(12, '\0')).faces() == 2);
  CHECK(read(binary_stl(2, 2) + "\r\n").faces() == 2);
  check_fault(Fault::file_trailing, "byte 184", [] { read(binary_stl(2, 2) + "more"); });
  check_fault(Fault::file_trailing, "byte 184", [] { read(binary_stl(2, 3)); });
  check_fault(Fault::file_trailing, "byte 184", [] { read(binary_stl(2, 2) + std::string(4000, '\0')); });
  CHECK(read(binary_stl(0, 0)).faces() == 0);
}

TEST_CASE("ASCII STL") {
  const RawMesh m = read("solid a name, with words\n" + facet() + facet("nan -nan(ind) 0") + "endsolid a name\n");
  CHECK(m.faces() == 2);
  CHECK(m.position[2] == Vec3(0, -0.25, 3));
  CHECK(read("\n solid\n" + facet() + "endsolid").faces() == 1);
  CHECK(
      read("SOLID X\r\nFACET NORMAL 0 0 1\r\nOUTER LOOP\r\nVERTEX 0 0 0\r\nVERTEX 1 0 0\r\nVERTEX 0 1 0\r\nENDLOOP\r\n"
           "ENDFACET\r\nENDSOLID X\r\n")
          .faces() == 1);
  CHECK(read("solid a\n" + facet() + "endsolid a\nsolid b\n" + facet() + "endsolid b\n\n").faces() == 2);
  CHECK(read("\xef\xbb\xbfsolid \xc3\xa9\n" + facet() + "endsolid\n").faces() == 1);
}

TEST_CASE("ASCII STL cut off") {
  const std::string whole = "solid a\n" + facet() + facet() + "endsolid a\n";
  for (std::size_t size = 9; size + 4 < whole.size() - 8; size += 3)
    check_fault(Fault::file_truncated, "line ", [&] {
      // Cut between words: in one it is a word that is not known, or a number that is.
      read(whole.substr(0, whole.find_last_of(" \n", size)) + "\n");
    });
}

TEST_CASE("ASCII STL that is wrong says where") {
  check_fault(Fault::file_syntax, "line 5: expected a coordinate, found '1,5'", [] {
    read(
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1,5 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid\n");
  });
  check_fault(Fault::file_syntax, "line 7: expected 'endloop', found 'vertex'", [] {
    read(
        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid\n");
  });
  check_fault(Fault::file_syntax, "line 2: expected 'facet' or 'endsolid'", [] { read("solid\nnonsense\n"); });
  check_fault(Fault::file_trailing, "line 10", [] { read("solid\n" + facet() + "endsolid\nmore\n"); });
}
