// A file that comes into being whole or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

namespace ts {

// Written to a temporary file beside its place, which commit() puts there. Without a commit nothing is left, and what
// was there stays. All throw Error{file_write}, and
// write() Error{cancelled} where the call that writes is to stop.
class OutputFile {
 public:
  explicit OutputFile(const std::string &path);  // UTF-8; must not name what is there and no regular file
  ~OutputFile();
  OutputFile(const OutputFile &) = delete;
  OutputFile &operator=(const OutputFile &) = delete;

  void write(std::string_view bytes);
  void put(std::uint32_t value);  // little-endian
  void put(float value);
  void commit();

 private:
  [[noreturn]] void fail(const std::string &why) const;

  std::string path_;
  std::filesystem::path place_, temporary_;
  std::ofstream out_;
  std::size_t unasked_ = 0;  // bytes since it was asked whether to stop
};

}  // namespace ts
