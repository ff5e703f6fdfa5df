#include "bench/features_image.h"

#include <array>
#include <cmath>
#include <fstream>

#include "features/analysis.h"

namespace ts::bench {
namespace {

using features::Strip;

struct Image {
  int width, height;
  std::vector<std::array<unsigned char, 3>> pixel;
  Image(int w, int h) : width(w), height(h), pixel(static_cast<std::size_t>(w) * h, {0, 0, 0}) {}
  void set(int x, int y, std::array<unsigned char, 3> c) {
    if (x >= 0 && y >= 0 && x < width && y < height) pixel[static_cast<std::size_t>(y) * width + x] = c;
  }
};

unsigned char shade(double v) {
  return static_cast<unsigned char>(255 * std::min(1.0, std::max(0.0, v)));
}

std::array<unsigned char, 3> colour(int label) {
  const unsigned h = static_cast<unsigned>(label) * 2654435761u;
  return {static_cast<unsigned char>(80 + (h >> 8) % 170), static_cast<unsigned char>(80 + (h >> 16) % 170),
          static_cast<unsigned char>(80 + (h >> 24) % 170)};
}

}  // namespace

void draw_strip(const std::string &file, const ScanFolder &scan, const features::Features &found) {
  const Executor executor(1);
  const features::Analysis a = features::analyse(scan.surface, {}, executor, {});
  constexpr int zoom = 3, panel = Strip::across * zoom + 6;
  Image image(a.strip.slices * zoom, 3 * panel);
  for (int x = 0; x < image.width; ++x)
    for (int y = 0; y < Strip::across * zoom; ++y) {
      const int i = x / zoom, j = y / zoom;
      const std::size_t c = a.strip.at(i, j);
      if (std::isnan(a.strip.height[c])) continue;
      const unsigned char h = shade(1 - (a.strip.top[i] - a.strip.height[c]) / 8);
      image.set(x, y, {h, h, h});
      const double cv = a.strip.fine[c];
      image.set(x, y + panel, {shade(0.3 + 2 * cv), shade(0.3), shade(0.3 - 2 * cv)});
      const mesh::Index f = a.view.face(a.strip.plan_point(i, Strip::t(j)));
      const int label = f == mesh::none || scan.label.empty() ? 0 : scan.label[f];
      image.set(x, y + 2 * panel, label ? colour(label) : std::array<unsigned char, 3>{30, 30, 30});
    }
  for (const auto &g : found.groups) {
    for (int p = 0; p < 3; ++p)
      for (int y = 0; y < Strip::across * zoom; ++y)
        if (y % 6 < 3) {
          image.set(static_cast<int>(g.from / Strip::step * zoom), y + p * panel, {0, 255, 0});
          image.set(static_cast<int>(g.to / Strip::step * zoom) - 1, y + p * panel, {255, 255, 0});
        }
    for (const auto &point : g.points) {
      // the cell of the strip nearest to the point in plan view
      const features::Vec2 q = a.plan.of(point.position).head<2>();
      double nearest = 1e9;
      int bi = 0, bj = 0;
      for (int i = 0; i < a.strip.slices; ++i)
        for (int j = 0; j < Strip::across; ++j)
          if (const double d = (a.strip.plan_point(i, Strip::t(j)) - q).squaredNorm(); d < nearest)
            nearest = d, bi = i, bj = j;
      for (int p = 0; p < 3; ++p)
        for (int dx = -3; dx <= 3; ++dx)
          for (int dy = -3; dy <= 3; ++dy) image.set(bi * zoom + dx, bj * zoom + dy + p * panel, {255, 40, 40});
    }
  }
  std::ofstream out(file, std::ios::binary);
  out << "P6\n" << image.width << " " << image.height << "\n255\n";
  out.write(reinterpret_cast<const char *>(image.pixel.data()), static_cast<std::streamsize>(3 * image.pixel.size()));
}

}  // namespace ts::bench
