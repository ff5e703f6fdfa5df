// PLY, ASCII or binary: the positions of "vertex", the index list of "face"; all else is passed over.
#include <algorithm>
#include <bit>
#include <cmath>

#include "mesh/file_size.h"
#include "mesh/ply_header.h"
#include "mesh/read.h"

namespace ts::mesh {
namespace {

using Bytes = std::span<const std::byte>;

// The values behind the header one after another, whatever their coding. What both sources have in common is that
// a value past the end is file_truncated.
class BinarySource {
 public:
  BinarySource(Bytes file, std::size_t at, bool big) : file_(file), at_(at), big_(big) {}

  double real(PlyType type) {
    const std::uint64_t bits = take(size_of(type));
    if (type == PlyType::float32) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (type == PlyType::float64) return std::bit_cast<double>(bits);
    return static_cast<double>(as_integer(type, bits));
  }
  long long integer(PlyType type) { return as_integer(type, take(size_of(type))); }
  void skip(PlyType type, std::uint64_t count) {
    if (count > left() / size_of(type)) cut_off();
    at_ += size_of(type) * static_cast<std::size_t>(count);
  }
  std::uint64_t left() const { return file_.size() - at_; }

  void end_file() const {
    const Bytes rest = file_.subspan(at_);
    if (rest.size() <= 64 && std::all_of(rest.begin(), rest.end(), [](std::byte b) {
          const int c = std::to_integer<int>(b);
          return c == 0 || c == ' ' || (c >= 9 && c <= 13);
        }))
      return;
    fail(Fault::file_trailing, std::to_string(rest.size()) + " bytes follow the last element of the header");
  }
  [[noreturn]] void fail(Fault fault, const std::string &what) const {
    throw Error(fault, "byte " + std::to_string(at_) + ": " + what);
  }

 private:
  std::uint64_t take(std::size_t n) {
    if (left() < n) cut_off();
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < n; ++i)
      bits |= std::to_integer<std::uint64_t>(file_[at_ + i]) << 8 * (big_ ? n - 1 - i : i);
    at_ += n;
    return bits;
  }
  static long long as_integer(PlyType type, std::uint64_t bits) {
    switch (type) {
      case PlyType::int8: return static_cast<std::int8_t>(bits);
      case PlyType::int16: return static_cast<std::int16_t>(bits);
      case PlyType::int32: return static_cast<std::int32_t>(bits);
      default: return static_cast<long long>(bits);
    }
  }
  [[noreturn]] void cut_off() const { fail(Fault::file_truncated, "the file ends within an element of the header"); }

  Bytes file_;
  std::size_t at_;
  bool big_;
};

class AsciiSource {
 public:
  explicit AsciiSource(Text text) : text_(text) {}

  double real(PlyType) { return text_.real(text_.word(), "a number"); }
  long long integer(PlyType) { return text_.integer(text_.word(), "an integer"); }
  void skip(PlyType, std::uint64_t count) {
    for (; count > 0; --count) real(PlyType::float64);
  }
  std::uint64_t left() const { return text_.left() + 1; }  // the last number needs no blank behind it
  void end_file() {
    if (text_.find_word()) text_.fail(Fault::file_trailing, "text after the last element of the header");
  }
  [[noreturn]] void fail(Fault fault, const std::string &what) const { text_.fail(fault, what); }

 private:
  Text text_;
};

template <class Source>
class Body {
 public:
  Body(const PlyHeader &header, Source source, Progress progress)
      : header_(header), source_(source), progress_(progress) {}

  RawMesh read() {
    raw_.face_start.push_back(0);
    double done = 0;
    for (const PlyElement &e : header_.elements) {
      check_count(e.count, e.least_bytes(header_.coding), source_.left(), e.name + " elements");
      const double share = 1 / static_cast<double>(header_.elements.size());
      const Progress part = progress_.part(done, done + share, "reading");
      done += share;
      if (e.name == "vertex")
        read_vertices(e, part);
      else if (e.name == "face")
        read_faces(e, part);
      else
        pass_over(e, part);
    }
    source_.end_file();
    return std::move(raw_);
  }

 private:
  static void report(Progress part, std::uint64_t i, std::uint64_t n) {
    if (i % 65536 == 0) part(static_cast<double>(i) / static_cast<double>(n));
  }

  std::uint64_t list_size(const PlyProperty &p) {
    const long long n = source_.integer(p.count_type);
    if (n < 0) source_.fail(Fault::file_count, "a list of " + std::to_string(n));
    if (static_cast<std::uint64_t>(n) > source_.left())
      source_.fail(Fault::file_truncated, "a list of " + std::to_string(n) + " goes beyond the file");
    return static_cast<std::uint64_t>(n);
  }

  void pass_over(const PlyProperty &p) { source_.skip(p.type, p.is_list ? list_size(p) : 1); }

  void pass_over(const PlyElement &e, Progress part) {
    if (e.properties.empty()) return;
    for (std::uint64_t i = 0; i < e.count; ++i) {
      report(part, i, e.count);
      for (const PlyProperty &p : e.properties) pass_over(p);
    }
  }

  void read_vertices(const PlyElement &e, Progress part) {
    Vec<int> axis;  // a property: the coordinate it is, or -1
    for (const PlyProperty &p : e.properties)
      axis.push_back(p.is_list || p.name.size() != 1 || p.name < "x" || p.name > "z" ? -1 : p.name[0] - 'x');
    for (int k = 0; k < 3; ++k)
      if (std::count(axis.begin(), axis.end(), k) != 1)
        throw Error(Fault::file_format,
                    std::string("the vertices have no property ") + "xyz"[k] + ", or more than one");
    const std::size_t before = raw_.position.size();
    raw_.position.resize(before + static_cast<std::size_t>(e.count));
    for (std::uint64_t i = 0; i < e.count; ++i) {
      report(part, i, e.count);
      Vec3 &p = raw_.position[before + static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < axis.size(); ++k)
        if (axis[k] >= 0)
          p[axis[k]] = source_.real(e.properties[k].type);
        else
          pass_over(e.properties[k]);
    }
  }

  void read_corners(const PlyProperty &p) {
    for (std::uint64_t n = list_size(p); n > 0; --n) {
      const long long v = source_.integer(p.type);
      if (v < 0 || v >= none)
        source_.fail(Fault::mesh_index_range,
                     "face " + std::to_string(raw_.face_start.size() - 1) + " names vertex " + std::to_string(v));
      raw_.corner.push_back(static_cast<Index>(v));
    }
    if (raw_.corner.size() > 3 * most_elements) source_.fail(Fault::mesh_too_large, "more than 3 * 2^30 corners");
  }

  void read_faces(const PlyElement &e, Progress part) {
    const PlyProperty *corners = e.find("vertex_indices");
    if (!corners) corners = e.find("vertex_index");
    if (!corners || !corners->is_list || !is_integer(corners->type))
      throw Error(Fault::file_format, "the faces have no list of integers 'vertex_indices' or 'vertex_index'");
    // Most faces are triangles, but no more corners can come than there are bytes.
    raw_.corner.reserve(raw_.corner.size() + static_cast<std::size_t>(std::min(3 * e.count, source_.left())));
    raw_.face_start.reserve(raw_.face_start.size() + static_cast<std::size_t>(e.count));
    for (std::uint64_t i = 0; i < e.count; ++i) {
      report(part, i, e.count);
      for (const PlyProperty &p : e.properties)
        if (&p == corners)
          read_corners(p);
        else
          pass_over(p);
      raw_.face_start.push_back(static_cast<Index>(raw_.corner.size()));
    }
  }

  const PlyHeader &header_;
  Source source_;
  Progress progress_;
  RawMesh raw_;
};

}  // namespace

RawMesh read_ply(std::span<const std::byte> file, Progress progress) {
  Text text(as_text(file));
  const PlyHeader header = read_ply_header(text);
  const auto has = [&](std::string_view name) {
    return std::any_of(header.elements.begin(), header.elements.end(),
                       [&](const PlyElement &e) { return e.name == name; });
  };
  if (!has("vertex")) throw Error(Fault::file_format, "no element 'vertex'");
  if (!has("face") && has("tristrips")) throw Error(Fault::file_format, "PLY triangle strips are not read");
  if (header.coding == PlyCoding::ascii) return Body(header, AsciiSource(text), progress).read();
  return Body(header, BinarySource(file, text.at(), header.coding == PlyCoding::big_endian), progress).read();
}

}  // namespace ts::mesh
