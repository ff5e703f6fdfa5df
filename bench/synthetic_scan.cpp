#include "bench/synthetic_scan.h"

#include <memory>
#include <stdexcept>

#include "toothseg_arch.h"

namespace ts::bench {

ScanFolder synthetic_scan(bool upper, double crowding, unsigned seed, const std::vector<std::uint32_t> &missing,
                          std::uint32_t triangles) {
  const auto check = [](int status) {
    if (status != TSA_OK) throw std::runtime_error(tsa_last_error_message());
  };
  tsa_options options{};
  check(tsa_options_init(&options, sizeof options));
  options.jaw = upper ? TSA_JAW_UPPER : TSA_JAW_LOWER;
  options.triangles = triangles;
  options.seed = seed;
  options.crowding = crowding;
  options.missing = missing.data();
  options.missing_count = static_cast<std::uint32_t>(missing.size());
  tsa_arch *made = nullptr;
  check(tsa_create(&options, &made));
  const std::unique_ptr<tsa_arch, decltype(&tsa_destroy)> arch(made, tsa_destroy);
  std::uint32_t vertices = 0, faces = 0, teeth = 0;
  check(tsa_get_positions(made, nullptr, 0, &vertices));
  check(tsa_get_triangles(made, nullptr, 0, &faces));
  check(tsa_get_teeth(made, nullptr, 0, &teeth));
  Vec<mesh::Vec3> position(vertices);
  Vec<mesh::Triangle> triangle(faces);
  Vec<std::uint32_t> label(faces), fdi(teeth);
  check(tsa_get_positions(made, position.data()->data(), vertices, &vertices));
  check(tsa_get_triangles(made, triangle.data()->data(), faces, &faces));
  check(tsa_get_labels(made, label.data(), faces, &faces));
  check(tsa_get_teeth(made, fdi.data(), teeth, &teeth));
  ScanFolder scan;
  scan.name = std::string(upper ? "upper" : "lower") + "-crowding-" + std::to_string(crowding).substr(0, 4) + "-seed-" +
              std::to_string(seed) + (missing.empty() ? "" : "-missing");
  scan.surface = mesh::make_surface(std::move(position), std::move(triangle));
  for (const std::uint32_t l : label) scan.label.push_back(l ? static_cast<int>(fdi[l - 1]) : 0);
  return scan;
}

}  // namespace ts::bench
