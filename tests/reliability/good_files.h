// Files that are as they should be, of each format that the library reads. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toothseg.h>

#include <string>
#include <vector>

#include "scene.h"

enum class Coding { text, little_endian, big_endian };

struct GoodFile {
  std::string name;
  ts_file_format format;  // TS_FORMAT_AUTO of a session
  Coding coding;
  std::string bytes;
  std::uint32_t vertices, faces;  // as given; of a session those of its model

  bool session() const { return format == TS_FORMAT_AUTO; }
};

// Written here, and by the library where it writes the format; `folder` is for those. `sessions` are on the model of
// session_bumps().
std::vector<GoodFile> good_files(const std::string &folder);
Bumps session_bumps();
