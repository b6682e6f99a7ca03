// SPDX-License-Identifier: MIT
/// \file
/// packet_decoder against the protocol's rules in plain arithmetic (support/packet_stream.hpp), for every stream width
/// and every choice of channels.
#include "sheen/hls/packet_decoder.hpp"

#include <gtest/gtest.h>

#include <iostream>
#include <stdexcept>
#include <vector>

#include "support/kernel_records.hpp"

namespace sheen::test {
namespace {

constexpr unsigned seed = 20252;

template <typename shape>
using decoder_of = hls::packet_decoder<shape::words_per_beat, shape::has_depth, shape::has_quadratic,
                                       shape::log_channels, shape::has_power>;

/// A job in plain numbers; the words are those that the packet carries, in its order.
struct Job {
    bool message = false;
    int code = 0;
    std::uint32_t header = 0;
    bool leftward = false, linear = false, depth = false;
    std::vector<std::uint32_t> words;
    friend bool operator==(const Job& a, const Job& b) {
        return a.message == b.message && a.code == b.code && a.header == b.header && a.leftward == b.leftward &&
               a.linear == b.linear && a.depth == b.depth && a.words == b.words;
    }
    friend std::ostream& operator<<(std::ostream& out, const Job& job) {
        out << std::hex << (job.message ? "{message code " : "{triangle code ") << job.code << " header " << job.header
            << " flags " << job.leftward << job.linear << job.depth;
        for (const std::uint32_t word : job.words) out << ' ' << word;
        return out << std::dec << '}';
    }
};

Job expected_job(const StreamPacket& packet, const CoreShape& shape) {
    Job job;
    job.code = packet_error(packet, shape);
    job.message = job.code != 0 || !is_triangle(packet);
    const std::uint32_t header = packet[0].words[0];
    if (job.message) {
        job.header = header;
        return job;
    }
    job.leftward = (header >> 16 & 1) != 0;
    job.linear = (header >> 17 & 1) != 0;
    job.depth = (header >> 18 & 1) != 0;
    job.words = words_of(packet);
    job.words.erase(job.words.begin());
    return job;
}

template <typename shape>
Job job_of(const typename decoder_of<shape>::state_t& state) {
    using decoder = decoder_of<shape>;
    Job job;
    job.message = state.job.message != 0;
    if (job.message) {
        job.code = state.job.code.to_int();
        job.header = state.job.header.to_uint();
        return job;
    }
    job.leftward = state.job.leftward != 0;
    job.linear = state.job.linear != 0;
    job.depth = state.job.depth != 0;
    const auto take = [&](int first, int count) {
        for (int r = first; r < first + count; ++r) job.words.push_back(state.words[r].to_uint());
    };
    take(0, 10);
    for (int c = 0; c < 3 + state.job.log.to_int(); ++c)
        take(decoder::channel_base + c * decoder::channel_words, job.linear ? 3 : decoder::channel_words);
    if (job.depth) take(decoder::depth_base, decoder::register_count - decoder::depth_base);
    return job;
}

struct Outcome {
    std::vector<Job> jobs;
    std::int64_t clocks = 0;   ///< until the last beat was taken
    std::int64_t refused = 0;  ///< clocks in which a beat was offered and not taken
};

/// Streams the packets in; of 100 clocks, stall_percent offer no beat and as many leave a job waiting.
template <typename shape>
Outcome decode(const std::vector<StreamPacket>& packets, Rng& rng, unsigned stall_percent) {
    using decoder = decoder_of<shape>;
    typename decoder::state_t state;
    Outcome outcome;
    int material_arrives = 0;
    int table_arrives = 0;
    const auto stalls = [&] { return stall_percent != 0 && rng() % 100 < stall_percent; };
    const auto clock = [&](const typename decoder::beat_t& beat) {
        const bool taken = state.job.valid && !stalls();
        // The highlight stage tells of a message's arrival some clocks after it was taken.
        typename decoder::applied_t applied;
        applied.material = material_arrives != 0 && --material_arrives == 0;
        applied.table = table_arrives != 0 && --table_arrives == 0;
        if (taken && state.job.message != 0 && state.job.code == 0) {
            const std::uint32_t opcode = state.job.header.to_uint() >> 24;
            if (opcode == hls::opcode_material) material_arrives = 3;
            if (opcode == hls::opcode_table) table_arrives = 3;
        }
        state = decoder::step(state, beat, taken, applied);
        if (taken) outcome.jobs.push_back(job_of<shape>(state));  // channels load in the clock after
        ++outcome.clocks;
    };
    for (const StreamPacket& packet : packets) {
        for (const StreamBeat& beat : packet) {
            while (stalls()) clock(no_beat<decoder>(rng));
            const auto offered = beat_of<decoder>(beat);
            for (int waited = 0; !decoder::ready(state); ++waited) {
                if (waited > 1000) throw std::runtime_error("packet_decoder takes no beat");
                clock(offered);
                ++outcome.refused;
            }
            clock(offered);
        }
    }
    const std::int64_t clocks = outcome.clocks;
    for (int k = 0; k < 50; ++k) clock(no_beat<decoder>(rng));
    outcome.clocks = clocks;
    return outcome;
}

StreamPacket good_triangle(Rng& rng, const CoreShape& shape) {
    return framed(triangle_words(rng, random_walk(rng, 4095), shape), shape.words_per_beat);
}

StreamPacket malformed_packet(Rng& rng, const CoreShape& shape) {
    for (;;) {
        StreamPacket packet = random_packet(rng, random_walk(rng, 4095), shape);
        if (packet_error(packet, shape) != 0) return packet;
    }
}

class PacketDecoder : public testing::Test {
 protected:
    void SetUp() override { std::cout << "seed " << seed << '\n'; }

    /// Runs check(shape_t, Rng&) for each shape, on a trace that names it.
    template <typename Check>
    void for_shapes(Check check) {
        for_each_shape([&](auto shape) {
            SCOPED_TRACE("words_per_beat=" + std::to_string(shape.words_per_beat) + " depth=" +
                         std::to_string(shape.has_depth) + " quadratic=" + std::to_string(shape.has_quadratic));
            if (!HasFatalFailure()) check(shape);
        });
    }

    Rng rng_{seed};
};

TEST_F(PacketDecoder, GivesOneJobAPacketInOrderUnderAnyStalls) {
    for_shapes([&](auto shape) {
        for (int i = 0; i < 100; ++i) {
            std::vector<StreamPacket> packets;
            std::vector<Job> expected;
            for (int k = 0; k < 20; ++k) {
                packets.push_back(random_packet(rng_, random_walk(rng_, 4095), shape.value()));
                expected.push_back(expected_job(packets.back(), shape.value()));
            }
            const auto percent = static_cast<unsigned>(i % 3 == 0 ? 0 : uniform(rng_, 1, 80));
            ASSERT_EQ(decode<decltype(shape)>(packets, rng_, percent).jobs, expected) << "stream " << i;
        }
    });
}

TEST_F(PacketDecoder, AnswersAMalformedPacketOnceAndLeavesItsNeighboursAlone) {
    for_shapes([&](auto shape) {
        for (int i = 0; i < 500; ++i) {
            const std::vector<StreamPacket> packets = {good_triangle(rng_, shape.value()),
                                                       malformed_packet(rng_, shape.value()),
                                                       good_triangle(rng_, shape.value())};
            const std::vector<Job> jobs = decode<decltype(shape)>(packets, rng_, 0).jobs;
            ASSERT_EQ(jobs.size(), 3U) << "case " << i;
            ASSERT_EQ(jobs[0], expected_job(packets[0], shape.value())) << "case " << i;
            ASSERT_TRUE(jobs[1].message) << "case " << i;
            ASSERT_NE(jobs[1].code, 0) << "case " << i;
            ASSERT_EQ(jobs[1].header, packets[1][0].words[0]) << "case " << i;
            ASSERT_EQ(jobs[2], expected_job(packets[2], shape.value())) << "case " << i;
        }
    });
}

TEST_F(PacketDecoder, TakesABeatAClockFromTrianglesAtFullRate) {
    for_shapes([&](auto shape) {
        std::vector<StreamPacket> packets;
        std::size_t beats = 0;
        for (int k = 0; k < 200; ++k) {
            packets.push_back(good_triangle(rng_, shape.value()));
            beats += packets.back().size();
        }
        const Outcome outcome = decode<decltype(shape)>(packets, rng_, 0);
        ASSERT_EQ(outcome.refused, 0);
        ASSERT_EQ(outcome.clocks, static_cast<std::int64_t>(beats));
        ASSERT_EQ(outcome.jobs.size(), packets.size());
    });
}

TEST_F(PacketDecoder, KeepsAJobAndItsWordsUntilTheyAreTaken) {
    for_shapes([&](auto shape) {
        using decoder = decoder_of<decltype(shape)>;
        for (int i = 0; i < 50; ++i) {
            typename decoder::state_t state;
            const StreamPacket first = good_triangle(rng_, shape.value());
            const StreamPacket second = good_triangle(rng_, shape.value());
            for (const StreamBeat& beat : first) state = decoder::step(state, beat_of<decoder>(beat), 0);
            const Job expected = expected_job(first, shape.value());
            std::size_t taken = 0;
            for (int clock = 0; clock < 20; ++clock) {
                ASSERT_EQ(state.job.valid, 1) << "clock " << clock;
                const bool ready = decoder::ready(state) != 0;
                state = decoder::step(state, beat_of<decoder>(second[taken]), 0);
                ASSERT_EQ(job_of<decltype(shape)>(state), expected) << "clock " << clock;
                taken += ready ? 1 : 0;
            }
            ASSERT_EQ(taken, 1U) << "only the header fits beside a waiting job";
        }
    });
}

TEST_F(PacketDecoder, UnpacksTheGeometryThatTheHostPacked) {
    using decoder = decoder_of<shape_t<2, true, true>>;
    for (int i = 0; i < 2000; ++i) {
        const TriangleWalk walk = random_walk(rng_, 4095);
        typename decoder::state_t state;
        for (const StreamBeat& beat : framed(triangle_words(rng_, walk, {2, true, true}), 2)) {
            state = decoder::step(state, beat_of<decoder>(beat), 0);
        }
        const hls::geometry_t got = decoder::geometry(state);
        const hls::geometry_t want = geometry_of(walk);
        ASSERT_EQ(got.x, want.x);
        ASSERT_EQ(got.y, want.y);
        ASSERT_EQ(got.rows_above, want.rows_above);
        ASSERT_EQ(got.rows_below, want.rows_below);
        ASSERT_EQ(got.kappa, want.kappa);
        ASSERT_EQ(got.length, want.length);
        ASSERT_EQ(got.m, want.m);
        ASSERT_EQ(got.length_reload, want.length_reload);
        ASSERT_EQ(got.m_below, want.m_below);
        ASSERT_EQ(got.long_phase, want.long_phase);
        ASSERT_EQ(got.long_step, want.long_step);
        ASSERT_EQ(got.upper_phase, want.upper_phase);
        ASSERT_EQ(got.upper_step, want.upper_step);
        ASSERT_EQ(got.lower_phase, want.lower_phase);
        ASSERT_EQ(got.lower_step, want.lower_step);
    }
}

}  // namespace
}  // namespace sheen::test
