// SPDX-License-Identifier: MIT
/// \file
/// Setups and beats as the records that the kernels take.
#pragma once

#include <type_traits>

#include "packet_stream.hpp"
#include "sheen/hls/types.hpp"

namespace sheen::test {

/// The shape of a core as a type.
template <int words_per_beat_, bool has_depth_, bool has_quadratic_, int log_channels_ = 0, bool has_power_ = false>
struct shape_t {
    static constexpr int words_per_beat = words_per_beat_;
    static constexpr bool has_depth = has_depth_;
    static constexpr bool has_quadratic = has_quadratic_;
    static constexpr int log_channels = log_channels_;
    static constexpr bool has_power = has_power_;
    static CoreShape value() { return {words_per_beat, has_depth, has_quadratic, log_channels, has_power}; }
};

template <int words_per_beat, typename Visit>
void for_each_shape_of_width(Visit visit) {
    visit(shape_t<words_per_beat, false, false>{});
    visit(shape_t<words_per_beat, false, true>{});
    visit(shape_t<words_per_beat, true, false>{});
    visit(shape_t<words_per_beat, true, true>{});
}

/// Calls visit(shape_t) for shapes with log channels: every number of them, with and without power tables, every width.
template <typename Visit>
void for_each_lit_shape(Visit visit) {
    visit(shape_t<1, true, true, 1, true>{});
    visit(shape_t<2, false, true, 1, false>{});
    visit(shape_t<2, true, true, 3, true>{});
    visit(shape_t<4, true, true, 2, true>{});
}

/// Calls visit(shape_t) for each of the twelve plain shapes and those of for_each_lit_shape().
template <typename Visit>
void for_each_shape(Visit visit) {
    for_each_shape_of_width<1>(visit);
    for_each_shape_of_width<2>(visit);
    for_each_shape_of_width<4>(visit);
    for_each_lit_shape(visit);
}

/// The geometry fields, each modulo 2^12.
inline hls::geometry_t geometry_of(const TriangleWalk& walk) {
    hls::geometry_t g;
    g.x = walk.x;
    g.y = walk.y;
    g.rows_above = walk.rows_above;
    g.rows_below = walk.rows_below;
    g.kappa = walk.kappa;
    g.length = walk.length;
    g.m = walk.m;
    g.length_reload = walk.length_reload;
    g.m_below = walk.m_below;
    g.long_phase = walk.long_edge.phase;
    g.long_step = walk.long_edge.step;
    g.upper_phase = walk.upper.phase;
    g.upper_step = walk.upper.step;
    g.lower_phase = walk.lower.phase;
    g.lower_step = walk.lower.step;
    return g;
}

/// The beat as the decoder's input, valid.
template <typename decoder>
typename decoder::beat_t beat_of(const StreamBeat& beat) {
    typename decoder::beat_t b;
    b.valid = 1;
    b.last = beat.last;
    b.keep = static_cast<int>(beat.keep);
    constexpr int words = static_cast<int>(std::extent_v<decltype(b.words)>);
    for (int k = 0; k < words; ++k) b.words[k] = beat.words[static_cast<std::size_t>(k)];
    return b;
}

/// A beat that is not there: noise that nothing may look at.
template <typename decoder>
typename decoder::beat_t no_beat(Rng& rng) {
    StreamBeat noise;
    for (std::uint32_t& word : noise.words) word = static_cast<std::uint32_t>(rng());
    noise.keep = static_cast<unsigned>(rng() & 1U);
    noise.last = (rng() & 1U) != 0;
    typename decoder::beat_t b = beat_of<decoder>(noise);
    b.valid = 0;
    return b;
}

}  // namespace sheen::test
