#include "features/evidence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ts::features {
namespace {

constexpr int reach = 28;          // |t| <= 7 mm
constexpr double crown = 5;        // height of crown that counts, below its top, mm
constexpr double table_depth = 2;  // the occlusal table: within this of the slice's crest, mm

int slices_of(double mm) {
  return static_cast<int>(std::lround(mm / Strip::step));
}

// Width within 2 mm of the crest, as wide as within 4 mm along the arch, smoothed.
Vec<float> table_widths(const Strip &strip) {
  const int n = strip.slices;
  Vec<float> raw(n, 0), wide(n, 0), result(n, 0);
  for (int i = 0; i < n; ++i) {
    int first = Strip::across, last = -1;
    for (int j = Strip::half - reach; j <= Strip::half + reach; ++j)
      if (strip.height[strip.at(i, j)] > strip.crest[i] - table_depth && strip.convexity[strip.at(i, j)] > -0.1f)
        first = std::min(first, j), last = j;
    if (last >= 0) raw[i] = static_cast<float>((last - first + 1) * Strip::step);
  }
  const int window = slices_of(2), blur = slices_of(3);
  for (int i = 0; i < n; ++i) {
    Vec<float> near(raw.begin() + std::max(0, i - window), raw.begin() + std::min(n, i + window + 1));
    std::nth_element(near.begin(), near.begin() + near.size() * 3 / 4, near.end());
    wide[i] = near[near.size() * 3 / 4];
  }
  for (int i = 0; i < n; ++i) {
    double sum = 0, weight = 0;
    for (int k = std::max(0, i - blur); k <= std::min(n - 1, i + blur); ++k) {
      const double w = 1 - std::abs(k - i) / (blur + 1.0);
      sum += w * wide[k];
      weight += w;
    }
    result[i] = static_cast<float>(sum / weight);
  }
  return result;
}

// The strip sheared by a slant: line i runs through (i, t = 0).
struct Line {
  double area = 0;      // above top - 5 mm, mm^2
  float crest = -1e9f;  // highest point
};

class Sheared {
 public:
  Sheared(const Strip &strip, double degrees) : strip_(strip), degrees_(degrees) {
    const double tangent = std::tan(degrees * std::numbers::pi / 180);
    for (int j = 0; j < Strip::across; ++j)
      shift_[j] = static_cast<int>(std::lround(Strip::t(j) * tangent / Strip::step));
    cosine_ = std::cos(degrees * std::numbers::pi / 180);
  }

  // The cell of line i at j, or -1.
  long cell(int i, int j) const {
    const int k = i + shift_[j];
    return k < 0 || k >= strip_.slices ? -1 : static_cast<long>(strip_.at(k, j));
  }

  Line line(int i) const {
    Line l;
    for (int j = Strip::half - reach; j <= Strip::half + reach; ++j) {
      const long c = cell(i, j);
      if (c < 0) continue;
      const float h = strip_.height[c];
      if (!(h > strip_.top[i] - crown)) continue;
      l.area += (h - (strip_.top[i] - crown)) * Strip::step;
      l.crest = std::max(l.crest, h);
    }
    return l;
  }

  void measure(int i, const Vec<Line> &lines, const Vec<float> &table, CutTerms &terms) const {
    using M = CutMeasure;
    std::array<double, M::count> m{};
    const auto [area_left, crest_left] = beside(lines, i, -1);
    const auto [area_right, crest_right] = beside(lines, i, +1);
    const double area = std::log(lines[i].area + 1);
    m[M::bias] = 1;
    m[M::area_mean] = area - (std::log(area_left + 1) + std::log(area_right + 1)) / 2;
    m[M::area_least] = area - std::log(std::min(area_left, area_right) + 1);
    const double low = strip_.top[i] - crown;
    const double crest = std::max<double>(lines[i].crest, low);
    m[M::notch] = std::min(std::max<double>(crest_left, low), std::max<double>(crest_right, low)) - crest;
    double ridge = -0.3, fine = -0.3, valley = 0, bend = 0, weight = 0;
    const int out = slices_of(1);
    for (int j = Strip::half - reach; j <= Strip::half + reach; ++j) {
      const long c = cell(i, j);
      if (c < 0) continue;
      const double h = strip_.height[c], above = h - (strip_.top[i] - crown);
      if (!(above > 0)) continue;
      ridge = std::max<double>(ridge, strip_.convexity[c]);
      fine = std::max<double>(fine, strip_.fine[c]);
      valley += above * strip_.fine[c];
      const long a = cell(i - out, j), b = cell(i + out, j);
      if (a >= 0 && b >= 0) {
        const double second = strip_.height[a] + strip_.height[b] - 2 * h;
        if (!std::isnan(second)) bend += above * std::clamp(second, -1.0, 2.0) / (cosine_ * cosine_);
      }
      weight += above;
    }
    m[M::ridge] = 10 * ridge;  // tens, so that all measures vary by about 1 and the prior of the fit treats them alike
    m[M::fine_ridge] = 10 * fine;
    m[M::valley] = weight > 0 ? 10 * valley / weight : 0;
    m[M::curvature] = weight > 0 ? bend / weight : 0;
    m[M::slant] = std::pow(degrees_ / 40, 2);
    const double posterior = std::clamp((table[i] - 4.0) / 2.0, 0.0, 1.0);
    for (int k = 0; k < M::count; ++k) {
      terms[k] = static_cast<float>((1 - posterior) * m[k]);
      terms[M::count + k] = static_cast<float>(posterior * m[k]);
    }
  }

 private:
  // Largest area and crest of the lines 1.5 to 5.5 mm to one side.
  static std::pair<double, float> beside(const Vec<Line> &lines, int i, int side) {
    std::pair<double, float> most{0, -1e9f};
    for (int k = slices_of(1.5); k <= slices_of(5.5); ++k) {
      const int l = i + side * k;
      if (l < 0 || l >= static_cast<int>(lines.size())) break;
      most.first = std::max(most.first, lines[l].area);
      most.second = std::max(most.second, lines[l].crest);
    }
    return most;
  }

  const Strip &strip_;
  double degrees_, cosine_;
  std::array<int, Strip::across> shift_;
};

SliceTerms measure_slice(const Strip &strip, int i, float envelope) {
  using M = SliceMeasure;
  SliceTerms m{};
  m[M::bias] = 1;
  if (std::isnan(strip.crest[i])) {
    m[M::hole] = 1;
    return m;
  }
  double rough = 0, relief = 0;
  float peak = -0.2f, fine = -0.2f;
  int cells = 0, holes = 0;
  for (int j = Strip::half - reach; j <= Strip::half + reach; ++j) {
    const std::size_t c = strip.at(i, j);
    const float h = strip.height[c];
    const bool inner = std::abs(j - Strip::half) <= slices_of(4);
    relief += std::isnan(h) ? 0 : std::clamp<double>(strip.crest[i] - h, 0, crown);
    if (std::isnan(h)) {
      holes += inner;
      continue;
    }
    if (h > strip.crest[i] - crown && inner) rough += std::abs(strip.convexity[c]), ++cells;
    peak = std::max(peak, strip.convexity[c]);
    fine = std::max(fine, strip.fine[c]);
  }
  m[M::roughness] = cells ? static_cast<float>(10 * rough / cells) : 0;
  m[M::peak] = 4 * peak;
  m[M::fine_peak] = 4 * fine;
  m[M::drop] = std::min(2.f, (envelope - strip.crest[i]) / 3);
  m[M::relief] = static_cast<float>(relief / (2 * reach + 1) / 3);
  m[M::hole] = static_cast<float>(holes) / static_cast<float>(2 * slices_of(4) + 1);
  return m;
}

}  // namespace

Evidence gather(const Strip &strip, const Executor &executor) {
  Evidence e;
  const int n = e.slices = strip.slices;
  e.table = table_widths(strip);
  e.cut.assign(static_cast<std::size_t>(n) * Slants::count, CutTerms{});
  executor.each(Slants::count, [&](std::size_t k) {
    const Sheared sheared(strip, Slants::degrees(static_cast<int>(k)));
    Vec<Line> lines(n);
    for (int i = 0; i < n; ++i) lines[i] = sheared.line(i);
    for (int i = 0; i < n; ++i)
      if (!std::isnan(strip.crest[i]))
        sheared.measure(i, lines, e.table, e.cut[static_cast<std::size_t>(i) * Slants::count + k]);
  });
  e.slice.assign(n + 1, SliceTerms{});
  const int window = slices_of(12);
  for (int i = 0; i < n; ++i) {
    float envelope = strip.crest[i];
    for (int k = std::max(0, i - window); k <= std::min(n - 1, i + window); ++k)
      envelope = std::fmax(envelope, strip.crest[k]);
    const SliceTerms m = measure_slice(strip, i, envelope);
    for (int k = 0; k < slice_terms; ++k) e.slice[i + 1][k] = e.slice[i][k] + static_cast<float>(Strip::step) * m[k];
  }
  return e;
}

}  // namespace ts::features
