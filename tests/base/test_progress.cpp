#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/progress.h"

namespace {

struct Recorder : ts::Monitor {
  bool proceed(double fraction, const char *stage) noexcept override {
    fractions.push_back(fraction);
    last_stage = stage;
    return fraction < stop_at;
  }
  std::vector<double> fractions;
  std::string last_stage;
  double stop_at = 2;
};

}  // namespace

TEST_CASE("a progress without a monitor does nothing") {
  CHECK_NOTHROW(ts::Progress()(0.5));
}

TEST_CASE("a part reports its share of the whole, under its name") {
  Recorder recorder;
  const ts::Progress whole(&recorder);
  const ts::Progress half = whole.part(0.5, 1, "second half");
  half(0);
  half.part(0.5, 1, "last quarter")(0.5);
  whole(1);
  CHECK(recorder.fractions == std::vector<double>{0.5, 0.875, 1});
  half(1);
  CHECK(recorder.last_stage == "second half");
}

TEST_CASE("a monitor that says stop cancels, and the message names the stage") {
  Recorder recorder;
  recorder.stop_at = 0.3;
  const ts::Progress p = ts::Progress(&recorder).part(0, 1, "knitting");
  CHECK_NOTHROW(p(0.2));
  try {
    p(0.4);
    FAIL("not cancelled");
  } catch (const ts::Error &e) {
    CHECK(e.fault() == ts::Fault::cancelled);
    CHECK(std::string(e.what()).find("knitting") != std::string::npos);
  }
}
