#include "base/whole_file.h"

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <new>

#include "base/output_file.h"
#include "base/patience.h"
#include "base/stop.h"

namespace ts {

namespace fs = std::filesystem;

namespace {

// What the system had no memory for is not the file's fault.
void need_memory() {
  if (errno == ENOMEM) throw std::bad_alloc();
}

}  // namespace

fs::path native_path(const std::string &path, Fault fault) {
  try {
    return {std::u8string(path.begin(), path.end())};
  } catch (const fs::filesystem_error &) {  // what the conversion to wide characters throws
    throw Error(fault, "the file's name is not UTF-8");
  }
}

Vec<std::byte> read_whole_file(const std::string &path) {
  const fs::path native = native_path(path, Fault::file_open);
  std::error_code code;
  if (fs::is_directory(native, code)) throw Error(Fault::file_open, "'" + path + "' is a directory");
  errno = 0;
  std::ifstream in(native, std::ios::binary);
  for (Patience open; !in && errno == EACCES && open.again();) {
    errno = 0;
    in.open(native, std::ios::binary);
  }
  if (!in) need_memory();
  if (!in) throw Error(Fault::file_open, "cannot open '" + path + "'");
  Vec<std::byte> bytes;
  std::size_t size = 0;
  const std::uintmax_t expected = fs::file_size(native, code);
  bytes.resize(code ? std::size_t{1} << 20 : static_cast<std::size_t>(expected) + 1);
  for (;;) {
    constexpr std::size_t piece = std::size_t{1} << 22;  // between two looks at whether to stop
    stop_if_asked();
    in.read(reinterpret_cast<char *>(bytes.data() + size),
            static_cast<std::streamsize>(std::min(piece, bytes.size() - size)));
    size += static_cast<std::size_t>(in.gcount());
    if (in.eof()) break;
    if (!in) throw Error(Fault::file_open, "cannot read '" + path + "' beyond byte " + std::to_string(size));
    if (size == bytes.size()) bytes.resize(2 * bytes.size());
  }
  bytes.resize(size);
  return bytes;
}

void write_whole_file(const std::string &path, std::span<const char> bytes) {
  const fs::path to = native_path(path, Fault::file_write);
  std::error_code error;
  // What is no file, a device or a pipe, is not replaced but written to.
  const fs::file_status status = fs::status(to, error);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status)) {
    errno = 0;
    std::ofstream out(to, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush();
    if (!out) need_memory();
    if (!out) throw Error(Fault::file_write, "'" + path + "' cannot be written");
    return;
  }
  OutputFile out(path);
  out.write({bytes.data(), bytes.size()});
  out.commit();
}

}  // namespace ts
