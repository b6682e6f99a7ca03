// SPDX-License-Identifier: MIT
/// \file
/// highlight_stage with its power memories, and what a decoder and a span walker send it: random pixels and messages,
/// materials and tables in their place.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "expected_pixels.hpp"
#include "packet_stream.hpp"
#include "sheen/hls/highlight_stage.hpp"

namespace sheen::test {

/// What a stage is configured with.
template <typename stage>
constexpr int log_channels_of = 0;
template <int log_channels, bool has_power>
constexpr int log_channels_of<hls::highlight_stage<log_channels, has_power>> = log_channels;
template <typename stage>
constexpr bool has_power_of = false;
template <int log_channels, bool has_power>
constexpr bool has_power_of<hls::highlight_stage<log_channels, has_power>> = has_power;

/// What comes to the stage in a clock.
template <typename stage>
struct HighlightInput {
    hls::fragment_t fragment;
    typename stage::values_t values;
    hls::material_t pending;
    hls::table_write_t write;
};

/// The stage with its power memories, a clock at a time.
template <typename stage>
class HighlightBench {
 public:
    const typename stage::state_t& clock(const HighlightInput<stage>& input) {
        typename stage::reads_t reads;
        for (std::size_t k = 0; k < memories_.size(); ++k) {
            reads.word[k] = memories_[k][state_.tables[k].power_state.address.to_uint()];
        }
        state_ = stage::step(state_, input.fragment, input.values, input.pending, reads);
        if (input.write.valid != 0) {
            for (auto& memory : memories_) memory[stage::power::place(input.write).to_uint()] = input.write.data;
        }
        return state_;
    }

 private:
    typename stage::state_t state_;
    std::array<std::vector<hls::word_t>, log_channels_of<stage>> memories_ = [] {
        std::array<std::vector<hls::word_t>, log_channels_of<stage>> memories;
        memories.fill(std::vector<hls::word_t>(stage::power::words, 0));
        return memories;
    }();
};

/// Of an 8-bit step, in the stage's sums.
inline constexpr int parts = 1 << hls::colour_sum_fraction_bits;
/// The same of an ambient field's unit, 1/16 step.
inline constexpr unsigned field_units = 16 / parts;

/// Any diffuse colours, and log channels mostly where highlights show.
template <typename stage>
typename stage::values_t random_values(Rng& rng) {
    const auto diffuse = [&] {
        return static_cast<int>(uniform(rng, -512 * parts, 512 * parts - 1)) >> uniform(rng, 0, 2);
    };
    typename stage::values_t values;
    values.red = diffuse();
    values.green = diffuse();
    values.blue = diffuse();
    values.depth = static_cast<int>(uniform(rng, 0, 65535));
    for (auto& log : values.log) {
        log = static_cast<int>(uniform(rng, 0, 3) == 0 ? uniform(rng, -8192, 8191) : uniform(rng, -50, 1100));
    }
    return values;
}

inline hls::fragment_t random_fragment(Rng& rng, int log_channels) {
    hls::fragment_t fragment;
    fragment.valid = 1;
    fragment.log = log_channels;
    fragment.x = static_cast<int>(uniform(rng, 0, 4095));
    fragment.y = static_cast<int>(uniform(rng, 0, 4095));
    fragment.tail = static_cast<int>(uniform(rng, 0, 4095));
    return fragment;
}

/// A message as edge_walker sends it: {opcode, 00, code} in its tail.
inline hls::fragment_t message_of(Rng& rng, int opcode, int code) {
    hls::fragment_t fragment = random_fragment(rng, static_cast<int>(uniform(rng, 0, 3)));
    fragment.message = 1;
    fragment.tail = opcode << 4 | code;
    return fragment;
}

/// A message that is none of the stage's own: a fence, an error (of a material, for one), a word of a query's reply
/// (whose tail counts, and may look like anything).
inline hls::fragment_t foreign_message(Rng& rng) {
    const int opcode = static_cast<int>(uniform(rng, 0, 5));
    switch (uniform(rng, 0, 2)) {
        case 0:
            return message_of(rng, hls::opcode_fence, 0);
        case 1:
            return message_of(rng, opcode, static_cast<int>(uniform(rng, 1, 3)));
        default: {
            hls::fragment_t query = message_of(rng, opcode, 0);
            query.query = 1;
            return query;
        }
    }
}

/// What a decoder does for the stage: it holds a material, or fills the bank that is not read, then sends a message;
/// until that has arrived nothing is changed, afterwards anything may come.
template <typename stage>
class HighlightSource {
 public:
    explicit HighlightSource(Rng& rng) : rng_(rng) {}

    /// This clock's fragment, material and write; `lighting` is what the pixels from here on are made with.
    HighlightInput<stage> next(Lighting& lighting) {
        HighlightInput<stage> input;
        input.values = random_values<stage>(rng_);
        hold_material();
        if (has_power_of<stage>) write_table(input.write);
        input.pending = pending_;
        input.fragment = random_fragment(rng_, static_cast<int>(uniform(rng_, 0, log_channels_of<stage>)));
        const auto kind = uniform(rng_, 0, 15);
        if (kind < 2) {
            input.fragment = foreign_message(rng_);
        } else if (kind == 2) {  // a pause, with noise that would be a material's message
            input.fragment = message_of(rng_, static_cast<int>(uniform(rng_, 1, 2)), 0);
            input.fragment.valid = 0;
        } else if (kind == 3) {
            input.fragment = message_of(rng_, hls::opcode_material, 0);
            lighting.set_material(material_);
            material_waits_ = false;
            ++materials;
        } else if (written_ == 256 && input.write.valid == 0) {
            input.fragment = message_of(rng_, hls::opcode_table, 0);
            lighting.set_table(table_);
            written_ = -8;  // the bank that was read is written no sooner than a decoder hears of it
            bank_ = 1 - bank_;
            ++tables;
        }
        return input;
    }

    int materials = 0;
    int tables = 0;

 private:
    void hold_material() {
        if (material_waits_) return;
        material_ = material_packet(rng_);
        if (!has_power_of<stage>) material_[2] &= ~0x70U;  // a core without power tables refuses such a material
        const std::uint64_t fields = material_[1] | static_cast<std::uint64_t>(material_[2]) << 32;
        pending_.red = (fields & 0xfffU) / field_units;
        pending_.green = (fields >> 12 & 0xfffU) / field_units;
        pending_.blue = (fields >> 24 & 0xfffU) / field_units;
        pending_.power = fields >> 36 & 7U;
        material_waits_ = uniform(rng_, 0, 1) == 0;
    }
    void write_table(hls::table_write_t& write) {
        if (written_ == 0) table_ = table_packet(rng_);
        if (written_ >= 0 && written_ < 256) {
            write.valid = 1;
            write.bank = bank_;
            write.address = written_;
            write.data = table_[static_cast<std::size_t>(written_ + 1)];
        }
        if (written_ < 256) ++written_;
    }

    Rng& rng_;
    std::vector<std::uint32_t> material_, table_;
    hls::material_t pending_;
    bool material_waits_ = false;
    int written_ = has_power_of<stage> ? 0 : -1;  ///< words of the table that are in the bank
    int bank_ = 1;                                ///< the first that is read is bank 0
};

}  // namespace sheen::test
