// SPDX-License-Identifier: MIT
/// \file
/// Top for an HLS tool: one clock of highlight_stage with one log channel and without power tables, the instance with
/// the fewest registers. Scalar ports only: the state's words in and out, the registers stand around it. Narrow fields
/// share a port from bit 0 up, in the order of their record. What this instance has no use for is no port: the bank,
/// kinds of log channels, the sums of two and three highlights.
#include <cstdint>

#include "sheen/hls/highlight_stage.hpp"

namespace {

using namespace sheen::hls;
using stage = highlight_stage<1, false>;
using port_t = ac_int<64, false>;

constexpr int colour_bits = stage::base_t::width;
constexpr int ambient_bits = stage::value_t::width;
constexpr int depth_lsb = 5 + 3 * coordinate_bits;

/// A fragment in bits 40–0, a depth above it.
void take_fragment(fragment_t& fragment, stage::depth_t& depth, const port_t& port) {
    fragment.valid = port[0];
    fragment.message = port[1];
    fragment.query = port[2];
    fragment.log = port.slc<flag_log_channels_bits>(3);
    fragment.x = port.slc<coordinate_bits>(5);
    fragment.y = port.slc<coordinate_bits>(5 + coordinate_bits);
    fragment.tail = port.slc<coordinate_bits>(5 + 2 * coordinate_bits);
    depth = port.slc<depth_bits>(depth_lsb);
}

std::uint64_t fragment_port(const fragment_t& fragment, const stage::depth_t& depth) {
    port_t port = 0;
    port.set_slc(0, fragment.valid);
    port.set_slc(1, fragment.message);
    port.set_slc(2, fragment.query);
    port.set_slc(3, fragment.log);
    port.set_slc(5, fragment.x);
    port.set_slc(5 + coordinate_bits, fragment.y);
    port.set_slc(5 + 2 * coordinate_bits, fragment.tail);
    port.set_slc(depth_lsb, depth);
    return port.to_uint64();
}

material_t material_of(const port_t& port) {
    material_t material;
    material.red = port.slc<ambient_bits>(0);
    material.green = port.slc<ambient_bits>(ambient_bits);
    material.blue = port.slc<ambient_bits>(2 * ambient_bits);
    return material;
}

void take_lane(stage::lane_t& lane, const port_t& fragment, const port_t& colour) {
    take_fragment(lane.fragment, lane.depth, fragment);
    lane.red = colour.slc<colour_bits>(0);
    lane.green = colour.slc<colour_bits>(colour_bits);
    lane.blue = colour.slc<colour_bits>(2 * colour_bits);
}

/// Three colours of one width.
template <typename value_t>
std::uint64_t colour_port(const value_t& red, const value_t& green, const value_t& blue) {
    port_t port = 0;
    port.set_slc(0, red);
    port.set_slc(value_t::width, green);
    port.set_slc(2 * value_t::width, blue);
    return port.to_uint64();
}

stage::exp2::state_t exp2_of(const port_t& port) {
    stage::exp2::state_t state;
    state.address = port.slc<6>(0);
    state.address_shift = port.slc<4>(6);
    state.address_none = port[10];
    state.data = port.slc<8>(11);
    state.data_shift = port.slc<4>(19);
    state.data_none = port[23];
    state.near = port.slc<12>(24);
    state.near_shift = port.slc<2>(36);
    state.near_none = port[38];
    state.value = port.slc<12>(39);
    return state;
}

std::uint64_t exp2_port(const stage::exp2::state_t& state) {
    port_t port = 0;
    port.set_slc(0, state.address);
    port.set_slc(6, state.address_shift);
    port.set_slc(10, state.address_none);
    port.set_slc(11, state.data);
    port.set_slc(19, state.data_shift);
    port.set_slc(23, state.data_none);
    port.set_slc(24, state.near);
    port.set_slc(36, state.near_shift);
    port.set_slc(38, state.near_none);
    port.set_slc(39, state.value);
    return port.to_uint64();
}

}  // namespace

/// fragment, fragment_*: a fragment and its depth; diffuse: s10.4 each; log: s8.6 in the low 14 bits; pending,
/// material: ambient u8.4 each; colour_*: u10.4 each; exp2: the state of the table; next_colour: s10.0 each.
extern "C" void highlight_stage_step(
    std::uint64_t fragment, std::uint64_t diffuse, std::int16_t log, std::uint64_t pending, std::uint64_t material,
    std::uint64_t fragment_0, std::uint64_t fragment_1, std::uint64_t fragment_2, std::uint64_t fragment_3,
    std::uint64_t colour_0, std::uint64_t colour_1, std::uint64_t colour_2, std::uint64_t colour_3, std::uint64_t exp2,
    std::uint64_t* next_material, bool* next_material_applied, bool* next_table_applied, std::uint64_t* next_fragment_0,
    std::uint64_t* next_fragment_1, std::uint64_t* next_fragment_2, std::uint64_t* next_fragment_3,
    std::uint64_t* next_colour_0, std::uint64_t* next_colour_1, std::uint64_t* next_colour_2,
    std::uint64_t* next_colour_3, std::uint64_t* next_exp2, std::uint64_t* next_fragment, std::uint32_t* next_colour) {
    static_assert(stage::latency == 5, "a port for each of four lanes");
    stage::state_t state;
    state.material = material_of(material);
    take_lane(state.lane[0], fragment_0, colour_0);
    take_lane(state.lane[1], fragment_1, colour_1);
    take_lane(state.lane[2], fragment_2, colour_2);
    take_lane(state.lane[3], fragment_3, colour_3);
    state.tables[0].exp2_state = exp2_of(exp2);
    fragment_t arriving;
    stage::values_t values;
    take_fragment(arriving, values.depth, fragment);
    const port_t colours = diffuse;
    values.red = colours.slc<colour_bits>(0);
    values.green = colours.slc<colour_bits>(colour_bits);
    values.blue = colours.slc<colour_bits>(2 * colour_bits);
    values.log[0] = log;

    const stage::state_t next = stage::step(state, arriving, values, material_of(pending), {});
    const auto lane_colour = [](const stage::lane_t& lane) { return colour_port(lane.red, lane.green, lane.blue); };
    *next_material = colour_port(next.material.red, next.material.green, next.material.blue);
    *next_material_applied = next.material_applied != 0;
    *next_table_applied = next.table_applied != 0;
    *next_fragment_0 = fragment_port(next.lane[0].fragment, next.lane[0].depth);
    *next_fragment_1 = fragment_port(next.lane[1].fragment, next.lane[1].depth);
    *next_fragment_2 = fragment_port(next.lane[2].fragment, next.lane[2].depth);
    *next_fragment_3 = fragment_port(next.lane[3].fragment, next.lane[3].depth);
    *next_colour_0 = lane_colour(next.lane[0]);
    *next_colour_1 = lane_colour(next.lane[1]);
    *next_colour_2 = lane_colour(next.lane[2]);
    *next_colour_3 = lane_colour(next.lane[3]);
    *next_exp2 = exp2_port(next.tables[0].exp2_state);
    *next_fragment = fragment_port(next.fragment, next.depth);
    *next_colour = static_cast<std::uint32_t>(colour_port(next.red, next.green, next.blue));
}
