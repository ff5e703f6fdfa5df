// Concavity at a physical radius, the measure that weights, cuts and clicks share.
#pragma once

#include "geometry/curvature.h"

namespace ts::geometry {

// Noise of the positions: median of |u_i - mean of the neighbours' u| over the mean edge, u_i the distance of vertex i
// from the mean of its ring along its normal. 0.024 to 0.052 on clean scans, 0.06 and more with noise of 0.05 edges.
double noise_gauge(const Surface &surface, const Vec<Vec3> &normal, const Executor &executor);

// mm over which the positions are smoothed before curvature is taken, for a reading of the gauge and the surface's mean
// edge in mm: 0 on clean scans.
double presmoothing(double gauge, double mean_edge);

// How deep the valleys are, 1/mm. `inside_out`: the faces look inwards, so that it is the bulges that are valleys.
struct Concavity {
  Vec<double> vertex;  // max(0, -kappa_min) of normals smoothed over `normal_radius`
  Vec<double> edge;  // how far the two faces turn towards each other over the distance of their middles; 0 on a border
  Vec<double> cotangent;  // cotangent_weights of the edges, at least 0.01
  // By what noise makes paths longer and areas larger; 1 on clean scans. Noise of half a mean edge: 1.5 and 2.
  double lengthened = 1, widened = 1;
};

Concavity concavity(const Surface &surface, double normal_radius, bool inside_out, const Executor &executor);

}  // namespace ts::geometry
