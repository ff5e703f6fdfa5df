// What can be set about a segmentation: ts_segment_options in C++, with the source of every default.
#pragma once

#include <cstddef>
#include <cstdint>

#include "field/weights.h"

namespace ts::tooth {

enum class Preset { standard, paper };

// What is held at the background value beside the neighbour tooth.
enum class Background {
  neighbour,  // nothing: the paper's pair (Eq. 10)
  gingiva,    // the vertices that are gingiva for certain
  all,        // these, and the points of all other groups
};

// How the contour of a tooth is chosen.
enum class CutRule {
  gradient,   // the paper's: largest mean gradient in [0, V_med] and in (V_med, 1]
  component,  // the component around the seeds with the best concavity x gradient, and a tooth's area
  half,       // half way between the tooth's value and the background's
};

struct Options {
  Preset preset = Preset::standard;
  field::Scheme weights = field::Scheme::concavity;
  Background background = Background::all;
  CutRule cut_rule = CutRule::component;
  std::uint32_t contours = 100;          // iso-values sampled in (0, 1) (Fig. 4A)
  std::uint32_t histogram_bins = 50;     // of Fig. 4C
  std::uint32_t points_per_group = 0;    // most points used a tooth (Figs. 2, 3), 0 = all
  double alpha = 1e8;                    // Eq. 6, the paper's value; 0 = exact constraints
  double beta = 1e-3;                    // paper: 0.01, the factor of a concave edge
  double gamma = 1e-4;                   // Eq. 8, the paper's value
  double theta = 0.2;                    // Eq. 9; paper: 0.001
  double c0 = 0.07;                      // 1/mm, decay of the CONCAVITY weights
  double normal_radius = 0.15;           // mm, r of the smoothed normals
  double seed_radius = 0.7;              // mm, disc of a constraint point; 0 = one vertex
  double gingiva_distance = 13;          // mm from every feature point at which gingiva begins for certain
  double area_min = 25, area_max = 330;  // mm^2, of a tooth
  double hole_area = 40;                 // mm^2, holes of a region up to this are filled
  double refine_band = 2.5;              // mm, half width of the band of the min-cut; 0 = none
  double smooth_radius = 0.2;            // mm, of the final line; 0 = none
  double click_reach = 2;                // mm, a click further from the surface is off it
  double click_concavity = 60;           // geodesic cost |e| (1 + this * concavity) from click to points
  bool reject_outliers = true;           // free feature points that contradict the field
  std::size_t memory_limit = 0;          // bytes that a prepared scan may keep; 0 = no limit
};

Options default_options();
Options paper_options();  // the paper to the letter

// Throws Fault::invalid_argument naming the option that is out of its range.
void check(const Options &options);

}  // namespace ts::tooth
