#include "base/output_file.h"

#include <bit>
#include <cerrno>
#include <cstdio>
#include <new>
#include <random>
#include <system_error>

#include "base/patience.h"
#include "base/stop.h"
#include "base/whole_file.h"

namespace ts {
namespace {

std::string reason(const std::string &otherwise) {
  if (errno == ENOMEM) throw std::bad_alloc();                        // not the file's fault
  return errno ? std::generic_category().message(errno) : otherwise;  // unlike strerror, for any thread
}

}  // namespace

void OutputFile::fail(const std::string &why) const {
  throw Error(Fault::file_write, "'" + path_ + "' cannot be written: " + why);
}

OutputFile::OutputFile(const std::string &path) : path_(path), place_(native_path(path, Fault::file_write)) {
  std::error_code code;
  if (std::filesystem::exists(place_, code) && !std::filesystem::is_regular_file(place_, code))
    fail("not a regular file");  // a rename would put a file in the place of a device
  char suffix[24];
  static_cast<void>(std::snprintf(suffix, sizeof suffix, ".part-%08x", static_cast<unsigned>(std::random_device()())));
  temporary_ = place_;
  temporary_ += suffix;
  errno = 0;
  out_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!out_) fail(reason("cannot be opened"));
}

OutputFile::~OutputFile() {
  if (temporary_.empty()) return;
  out_.close();
  std::error_code code;
  std::filesystem::remove(temporary_, code);
}

void OutputFile::write(std::string_view bytes) {
  constexpr std::size_t often = std::size_t{1} << 18;
  if ((unasked_ += bytes.size()) >= often) unasked_ = 0, stop_if_asked();
  errno = 0;
  if (!out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()))) fail(reason("write error"));
}

void OutputFile::put(std::uint32_t value) {
  char bytes[4];
  for (int i = 0; i < 4; ++i) bytes[i] = static_cast<char>(value >> 8 * i);
  write({bytes, 4});
}

void OutputFile::put(float value) {
  put(std::bit_cast<std::uint32_t>(value));
}

void OutputFile::commit() {
  errno = 0;
  out_.close();
  if (!out_) fail(reason("write error"));
  std::error_code code;
  std::filesystem::rename(temporary_, place_, code);
  for (Patience open; code == std::errc::permission_denied && open.again();)
    std::filesystem::rename(temporary_, place_, code);
  if (code == std::errc::not_enough_memory) throw std::bad_alloc();
  if (code) {  // Windows' own numbers have texts in the system's language and 8-bit characters
    const std::error_condition known = code.default_error_condition();
    fail(known.category() == std::generic_category() ? known.message() : "cannot be renamed");
  }
  temporary_.clear();
}

}  // namespace ts
