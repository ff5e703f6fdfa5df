#include <doctest/doctest.h>

#include <random>
#include <set>

#include "base/error.h"
#include "tooth/numbers.h"

using namespace ts;
using namespace ts::tooth;

namespace {

// Teeth of `present` places where an arch with all its teeth would have them, from the patient's right, 60 mm along.
ArchRow made_row(Jaw jaw, const std::set<int> &present, double size = 1, double depth_known = true) {
  ArchRow row;
  row.turn = jaw == Jaw::upper ? Turn::right : Turn::left;
  row.midline_from = 40;
  for (int i = 0; i <= 40; ++i) row.midline.push_back(-0.5 * (i - 20) * (i - 20) / 4.0);
  double at = 60;
  for (int p = 0; p < 8; ++p) at -= size * features::mean_width(jaw, p);
  for (int p = 0; p < features::places; ++p) {
    const double w = size * features::mean_width(jaw, p), d = size * features::mean_depth(jaw, p);
    if (present.contains(p)) {
      ArchTooth t;
      t.at = at + w / 2, t.width = w, t.crown = true;
      if (depth_known) t.depth = d;
      row.teeth.push_back(t);
    }
    at += w;
  }
  return row;
}

std::set<int> without(std::set<int> missing) {
  std::set<int> present;
  for (int p = 1; p < features::places - 1; ++p)
    if (!missing.contains(p)) present.insert(p);
  return present;
}

Vec<int> places_of(const std::set<int> &s) {
  return {s.begin(), s.end()};
}

// The same arch from its other end.
ArchRow turned_round(ArchRow row) {
  std::reverse(row.teeth.begin(), row.teeth.end());
  for (ArchTooth &t : row.teeth) t.at = -t.at;
  row.midline_from = -(row.midline_from + (double(row.midline.size()) - 1) * ArchRow::step);
  std::reverse(row.midline.begin(), row.midline.end());
  row.turn = row.turn == Turn::right ? Turn::left : row.turn == Turn::left ? Turn::right : Turn::unknown;
  return row;
}

template <class F>
Fault fault_told_by(F &&f) {
  try {
    f();
  } catch (const Error &e) {
    CHECK(std::string(e.what()).size() > 10);
    return e.fault();
  }
  return Fault::internal;
}

}  // namespace

TEST_CASE("FDI, Universal and Palmer, all of them") {
  // By hand: FDI in the order of Universal 1 to 32.
  constexpr int fdi[32] = {18, 17, 16, 15, 14, 13, 12, 11, 21, 22, 23, 24, 25, 26, 27, 28,
                           38, 37, 36, 35, 34, 33, 32, 31, 41, 42, 43, 44, 45, 46, 47, 48};
  std::set<std::uint32_t> valid;
  std::set<std::string> symbols, letters;
  for (std::uint32_t u = 1; u <= 32; ++u) {
    const auto f = static_cast<std::uint32_t>(fdi[u - 1]);
    valid.insert(f);
    CHECK(universal_of(f) == u);
    CHECK(fdi_of_universal(u) == f);
    CHECK(jaw_of(f) == (u <= 16 ? Jaw::upper : Jaw::lower));
    CHECK(fdi_of(jaw_of(f), place_of(f)) == f);
    CHECK(place_of(f) == static_cast<int>(u <= 16 ? u - 1 : 32 - u));
    const Palmer p = palmer_of(f);
    CHECK(p.quadrant == f / 10);
    CHECK(p.position == f % 10);
    CHECK(p.letters.size() == 3);
    symbols.insert(p.symbol);
    letters.insert(p.letters);
  }
  CHECK(symbols.size() == 32);
  CHECK(letters.size() == 32);
  CHECK(palmer_of(16).letters == "UR6");
  CHECK(palmer_of(16).symbol == "6\u2518");
  CHECK(palmer_of(21).symbol == "\u25141");
  CHECK(palmer_of(38).letters == "LL8");
  CHECK(palmer_of(38).symbol == "\u250c8");
  CHECK(palmer_of(43).symbol == "3\u2510");
  for (std::uint32_t n = 0; n < 1000; ++n) {
    CHECK(is_fdi(n) == valid.contains(n));
    if (is_fdi(n)) continue;
    CHECK(fault_told_by([&] { (void)universal_of(n); }) == Fault::invalid_argument);
    CHECK(fault_told_by([&] { (void)palmer_of(n); }) == Fault::invalid_argument);
    CHECK(fault_told_by([&] { (void)place_of(n); }) == Fault::invalid_argument);
  }
  CHECK(fault_told_by([] { (void)fdi_of_universal(0); }) == Fault::invalid_argument);
  CHECK(fault_told_by([] { (void)fdi_of_universal(33); }) == Fault::invalid_argument);
  CHECK(fault_told_by([] { (void)fdi_of(Jaw::upper, 16); }) == Fault::invalid_argument);
}

#ifdef TS_SANITIZED
constexpr int kPairStride = 5;  // ten times as slow
#else
constexpr int kPairStride = 1;
#endif

TEST_CASE("every tooth of arches of mean teeth, whichever one or two are missing, both jaws, both ways round" *
          doctest::test_suite("many arches")) {
  for (const Jaw jaw : {Jaw::upper, Jaw::lower})
    for (int a = 1; a < 15; ++a)
      for (int b = a; b < 15; b += kPairStride) {
        CAPTURE(a);
        CAPTURE(b);
        const std::set<int> present = without({a, b});
        const ArchRow row = made_row(jaw, present);
        Given given;
        given.jaw = jaw;
        const Numbering n = number_teeth(row, given);
        CHECK(n.place == places_of(present));
        CHECK(n.jaw_confidence == doctest::Approx(1));
        Numbering back = number_teeth(turned_round(row), given);
        std::reverse(back.place.begin(), back.place.end());
        CHECK(back.place == n.place);
        const Numbering estimated = number_teeth(row, {});
        CHECK(estimated.jaw == jaw);
        CHECK(estimated.place == n.place);
        for (std::size_t i = 0; i < n.confidence.size(); ++i) {
          CHECK(n.confidence[i] > 0.5);
          CHECK(estimated.confidence[i] <= estimated.jaw_confidence + 1e-9);
        }
      }
}

TEST_CASE("what is left of an arch: a quadrant, two canines") {
  for (const Jaw jaw : {Jaw::upper, Jaw::lower}) {
    Given given;
    given.jaw = jaw;
    for (const std::set<int> &present : {std::set<int>{1, 2, 3, 4, 5, 6, 7}, {8, 9, 10, 11, 12, 13, 14}, {5, 10}})
      CHECK(number_teeth(made_row(jaw, present), given).place == places_of(present));
  }
}

TEST_CASE("small and large teeth, measured as they are") {
  std::mt19937 random(7);
  std::normal_distribution<double> error(0, 1);
  int teeth = 0, right = 0;
  for (int k = 0; k < 200; ++k) {
    const Jaw jaw = k % 2 ? Jaw::upper : Jaw::lower;
    std::set<int> missing;
    while (missing.size() < std::size_t(k % 5)) missing.insert(1 + int(random() % 14));
    const std::set<int> present = without(missing);
    ArchRow row = made_row(jaw, present, 1 + 0.05 * std::clamp(error(random), -2.0, 2.0));
    for (ArchTooth &t : row.teeth) {
      t.width *= std::exp(0.08 * error(random));
      t.depth *= std::exp(0.08 * error(random));
      t.at += 0.4 * error(random);
    }
    const Numbering n = number_teeth(row, {});
    const Vec<int> truth = places_of(present);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ++teeth;
      right += n.jaw == jaw && n.place[i] == truth[i];
    }
  }
  CHECK(right >= 0.97 * teeth);
}

TEST_CASE("left and right change places with a mirror, and cannot be told on a straight row") {
  const std::set<int> present = without({4});
  ArchRow row = made_row(Jaw::upper, present);
  Given given;
  given.jaw = Jaw::upper;
  given.mirrored = true;
  Vec<int> mirrored;
  for (const int p : present) mirrored.push_back(features::places - 1 - p);
  CHECK(number_teeth(row, given).place == mirrored);
  given.mirrored = false;
  row.turn = Turn::unknown;
  for (const double c : number_teeth(row, given).confidence) CHECK(c == doctest::Approx(0.5).epsilon(0.1));
  given.place.assign(present.size(), -1);
  given.place.front() = 14;  // one number tells the side
  const Numbering told = number_teeth(row, given);
  CHECK(told.place == mirrored);
  CHECK(told.confidence.back() > 0.9);
}

TEST_CASE("a number that is set: the others follow") {
  // Four teeth of the same width and nothing else: 44 and 45 as wide as 15 and 14.
  const ArchRow row = made_row(Jaw::lower, {10, 11, 12, 13}, 1, false);
  Numbers numbers;
  const Vec<Index> groups = {4, 7, 2, 9};
  numbers.set(row, groups, 7, 36);
  CHECK(numbers.number(4)->fdi == 35);
  CHECK(numbers.number(7)->fdi == 36);
  CHECK(numbers.number(7)->by_hand);
  CHECK(numbers.number(7)->confidence == 1);
  CHECK(!numbers.number(4)->by_hand);
  CHECK(numbers.number(2)->fdi == 37);
  CHECK(numbers.number(9)->fdi == 38);
  CHECK(numbers.number(5) == nullptr);
  CHECK(numbers.jaw().jaw == Jaw::lower);
  CHECK(numbers.jaw().given);

  const auto same = [&](const Numbers &a, const Numbers &b) {
    if (a.numbers().size() != b.numbers().size() || a.jaw().given != b.jaw().given) return false;
    for (std::size_t i = 0; i < a.numbers().size(); ++i)
      if (a.numbers()[i].fdi != b.numbers()[i].fdi || a.numbers()[i].by_hand != b.numbers()[i].by_hand) return false;
    return true;
  };
  const Numbers before = numbers;
  const auto refused = [&](Index group, std::uint32_t fdi) {
    const Fault f = fault_told_by([&] { numbers.set(row, groups, group, fdi); });
    CHECK(same(numbers, before));
    return f;
  };
  CHECK(refused(4, 0) == Fault::invalid_argument);
  CHECK(refused(4, 99) == Fault::invalid_argument);
  CHECK(refused(4, 16) == Fault::number_jaw);
  CHECK(refused(4, 36) == Fault::number_taken);
  CHECK(refused(4, 37) == Fault::number_order);
  CHECK(refused(2, 35) == Fault::number_order);
  CHECK(refused(7, 38) == Fault::number_order);  // leaves none for the two after it
  CHECK(fault_told_by([&] { numbers.forget(row, groups, 4); }) == Fault::not_found);
  NumberOptions upper;
  upper.jaw = Jaw::upper;
  CHECK(fault_told_by([&] { numbers.assign(row, groups, upper); }) == Fault::number_jaw);
  CHECK(same(numbers, before));
  numbers.set(row, groups, 7, 36);  // the same again
  CHECK(same(numbers, before));
  numbers.set(row, groups, 7, 45);  // another
  CHECK(numbers.number(7)->fdi == 45);
  CHECK(numbers.number(4)->fdi == 46);
  numbers.forget(row, groups, 7);
  CHECK(!numbers.number(7)->by_hand);
  CHECK(!numbers.jaw().given);
  // A tooth that is there no more takes its number with it.
  numbers.set(row, groups, 9, 37);
  ArchRow fewer = row;
  fewer.teeth.pop_back();
  const Vec<Index> left = {4, 7, 2};
  numbers.assign(fewer, left, {});
  CHECK(numbers.number(9) == nullptr);
  CHECK(!numbers.jaw().given);
}

TEST_CASE("more teeth than a jaw has") {
  ArchRow row = made_row(Jaw::upper, without({}));
  row.teeth.insert(row.teeth.begin(), 6, row.teeth.front());
  CHECK(fault_told_by([&] { (void)number_teeth(row, {}); }) == Fault::too_many_teeth);
  row.teeth.resize(17);
  CHECK(fault_told_by([&] { (void)number_teeth(row, {}); }) == Fault::too_many_teeth);
  row.teeth.resize(16);
  CHECK(number_teeth(row, {}).place.size() == 16);
  row.teeth.clear();
  CHECK(number_teeth(row, {}).place.empty());
}
