// SPDX-License-Identifier: MIT
/// \file
/// Where two pictures differ, made visible.
#pragma once

#include "sheen/image.hpp"
#include "sheen/reference.hpp"

namespace sheen {

/// error_map_gain times the absolute error of each component, saturated. The pictures are of one size.
Image error_map(const ReferenceImage& expected, const ReferenceImage& actual);
Image error_map(const Image& expected, const Image& actual);

}  // namespace sheen
