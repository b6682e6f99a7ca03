// SPDX-License-Identifier: MIT
/// \file
/// What each paper shows, measured: one function a part, which keeps its pictures and returns its numbers.
#pragma once

#include "pictures.hpp"

namespace sheen::paper {

/// Paper `spherical`: table 1 and the curves of figures 9 to 11.
ordered_json bell_curves();
/// Paper `spherical`: figures 5, 14, 15, and turned against separate vectors.
ordered_json spherical_pictures(const Album& album);
/// Paper `quadratic`, figures 8 to 11; paper `spherical`, figure 16.
ordered_json quadratic_pictures(const Album& album);
/// Paper `fast-phong`: sizes of the exponent table, triangles of 10 to 110 degrees of curvature.
ordered_json taylor_limits(const Album& album);
/// Every printed formula that is wrong, beside the right one.
ordered_json misprints(const Album& album);
/// Additions, multiplications, divisions, roots that the papers state, counted.
ordered_json operation_counts();
/// Fast-phong's table, quadratic's ratio, recurrence's factor: seconds of this machine.
ordered_json times();
/// Operations and time a pixel against pixels a triangle.
ordered_json break_even();

}  // namespace sheen::paper
