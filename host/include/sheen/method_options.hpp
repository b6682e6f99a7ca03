// SPDX-License-Identifier: MIT
/// \file
/// How a method is computed where its paper leaves a choice, or where its printed form is to be shown.
#pragma once

#include <cstddef>

namespace sheen {

/// Each method looks at its own part and ignores the rest.
struct MethodOptions {
    std::size_t log_channels = 3;           ///< `log-quadratic`: channels for highlights
    double log_node_limit = 1e9;            ///< `log-quadratic`: greatest node of such a channel; 94 fits 8 bits
    std::size_t taylor_table_bytes = 1024;  ///< `taylor`, `taylor-finite`: size of the exponent table
    double spherical_base = 2.0;            ///< `spherical`: exponent k of the bell cos^k that stands for cos^n
    bool spherical_minimax = false;         ///< `spherical`: `a` minimises the largest error, else it is the paper's
    bool spherical_separate = false;  ///< `spherical`: both vectors interpolated, else one rotated against the other
    int recurrence_pixels = 1;        ///< `recurrence`: pixels a step, 1 or 4
    bool recurrence_integer_index =
        false;                ///< `recurrence`: sampled by the paper's integer index, else at pixel centres
    bool as_printed = false;  ///< the paper's formula with its misprints, for comparison
};

}  // namespace sheen
