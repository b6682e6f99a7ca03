// SPDX-License-Identifier: MIT
/// \file
/// colour_stage: channel values and a position in, one 64-bit output word out.
///
/// Colour is cut to its integer part (the host has folded +½ into I) and saturates to 0…255: the only place in the
/// datapath that saturates. Depth is the upper 16 bits of its channel. Messages are put together here, so that they
/// keep their place among the pixels. A position whose x is 4095 would read as a message: such pixels are dropped (no
/// image holds them).
///
/// Formats: colour s10.22 (or fewer fraction bits) to u8.0, depth u16.16 to u16.0. Latency: 2 (saturate, pack).
/// Source: paper `quadratic`, section 5 (Round as Trunc of +½).
#pragma once

#include "sheen/hls/types.hpp"

namespace sheen::hls {

/// What a core says of itself: the data of the four words of a query's reply (docs/packet-protocol.md).
struct core_description_t {
    word_t data[query_reply_words];
};

template <typename colour_t, typename depth_t>
struct colour_stage {
    struct values_t {
        colour_t red = 0, green = 0, blue = 0;
        depth_t depth = 0;
    };

    struct state_t {
        // Saturate.
        fragment_t fragment;
        component_t red = 0, green = 0, blue = 0;
        ac_int<depth_bits, false> depth = 0;
        // Pack: outputs.
        bit_t valid = 0;
        bit_t fence = 0;
        pixel_word_t word = 0;
    };

    static state_t step(const state_t& state, const fragment_t& fragment, const values_t& values,
                        const core_description_t& description) {
        state_t next;
        next.fragment = fragment;
        next.fragment.valid = fragment.valid & (fragment.message | bit_t(fragment.x != message_x));
        next.red = saturate(values.red);
        next.green = saturate(values.green);
        next.blue = saturate(values.blue);
        next.depth = values.depth.template slc<depth_bits>(depth_t::width - depth_integer_bits);

        const fragment_t& f = state.fragment;
        const ac_int<2, false> code = f.tail.template slc<2>(0);
        const bit_t is_fence = ~f.query & bit_t(code == 0);
        next.valid = f.valid;
        next.fence = f.message & is_fence;
        next.word = select(f.message, message_word(f, is_fence, code, description), pixel_word(state));
        return next;
    }

 private:
    /// Integer part of a colour, saturated to 0…255.
    static component_t saturate(const colour_t& value) {
        const ac_int<colour_integer_bits, false> integer =
            value.template slc<colour_integer_bits>(colour_t::width - colour_integer_bits);
        const bit_t negative = integer[colour_integer_bits - 1];
        const bit_t over = integer[component_bits];
        const component_t low = integer.template slc<component_bits>(0);
        const component_t full = -1;
        return select(negative, component_t(0), select(over, full, low));
    }

    static pixel_word_t pixel_word(const state_t& state) {
        pixel_word_t word = 0;
        word.set_slc(pixel_x_lsb, state.fragment.x);
        word.set_slc(pixel_y_lsb, state.fragment.y);
        word.set_slc(pixel_depth_lsb, state.depth);
        word.set_slc(pixel_red_lsb, state.red);
        word.set_slc(pixel_green_lsb, state.green);
        word.set_slc(pixel_blue_lsb, state.blue);
        return word;
    }

    static pixel_word_t message_word(const fragment_t& f, bit_t is_fence, ac_int<2, false> code,
                                     const core_description_t& description) {
        word_t header = 0;
        header.set_slc(0, f.x);
        header.set_slc(coordinate_bits, f.y);
        header.set_slc(header_opcode_lsb, f.tail.template slc<8>(4));
        const ac_int<2, false> index = f.x.template slc<2>(0);
        const word_t described = select(index[1], select(index[0], description.data[3], description.data[2]),
                                        select(index[0], description.data[1], description.data[0]));
        const coordinate_t kind = select(f.query, coordinate_t(message_query),
                                         select(is_fence, coordinate_t(message_fence), coordinate_t(message_error)));
        const coordinate_t x = message_x;
        pixel_word_t word = 0;
        word.set_slc(pixel_x_lsb, x);
        word.set_slc(pixel_y_lsb, kind);
        word.set_slc(pixel_depth_lsb, select(f.query, index, code));
        word.set_slc(word_bits, select(f.query, described, header));
        return word;
    }
};

}  // namespace sheen::hls
