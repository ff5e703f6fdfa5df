// Curvatures: principal (from normals, at a physical radius), Gaussian (from angles), and the paper's test of
// concavity.
#pragma once

#include "geometry/normals.h"

namespace ts::geometry {

// The principal curvatures at the vertices, 1/mm, positive where the surface bulges outwards: 1/R on a sphere.
struct Principal {
  Vec<double> least, greatest;
};

// Shape operator of each face by least squares on the differences of `normal` along its edges, averaged by area to the
// vertices and restricted to their tangent planes.
Principal principal_curvatures(const Surface &surface, const Vec<Vec3> &position, const Vec<Vec3> &normal,
                               const Executor &executor);

// G of Eq. 8, 1/mm^2: angle defect over a third of the area of the faces around. A boundary vertex has the defect from
// pi instead of 2 pi, its term in the theorem of Gauss and Bonnet: the defects add up to 2 pi (V - E + F) on any
// surface.
Vec<double> gaussian_curvature(const Surface &surface, const Executor &executor);

// The test of Eq. 9: 1 for the vertices with a neighbour for which the change of normal along the edge, against the
// edge, exceeds theta.
Vec<std::uint8_t> concave_by_edges(const Surface &surface, const Vec<Vec3> &normal, double theta,
                                   const Executor &executor);

}  // namespace ts::geometry
