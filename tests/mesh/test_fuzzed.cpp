// What the fuzzers of the readers found something in: it is read with its promises kept, or refused.
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.h"
#include "mesh/read.h"
#include "shapes.h"

using namespace shapes;

TEST_CASE("files that the fuzzers found something in") {
  const std::pair<const char *, Format> formats[] = {
      {"stl", Format::stl}, {"ply", Format::ply}, {"obj", Format::obj}, {"off", Format::off}};
  int made = 0;
  for (const auto &[name, format] : formats) {
    const std::filesystem::path folder = std::filesystem::path(TS_FUZZED) / name;
    if (!std::filesystem::exists(folder)) continue;
    for (const auto &entry : std::filesystem::directory_iterator(folder)) {
      INFO(entry.path().string());
      std::ifstream file(entry.path(), std::ios::binary);
      const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
      try {
        const Model m = model_of(read_mesh(std::as_bytes(std::span(bytes)), format, {}));
        check_promises(m);
        CHECK(m.report.flipped_faces <= m.report.input_faces);
        ++made;
      } catch (const ts::Error &e) {
        CHECK(std::string(e.what()) != "");
      }
    }
  }
  CHECK(made > 0);
}
