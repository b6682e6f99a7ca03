// SPDX-License-Identifier: MIT
#include "sheen/cycle_model.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <random>

#include "sheen/hls/formats.hpp"
#include "sheen/packet.hpp"
#include "sheen/raster.hpp"

namespace sheen {
namespace {

/// Clocks since the first beat was offered. Negative: before it, the time of what never has to be waited for.
using Clock = std::int64_t;
constexpr Clock long_ago = -1000;

// Places of the queues, and the clocks between their stages (rtl_vhdl/*.vhd; docs/cycle-model.md names each).
constexpr std::size_t beat_queue_places = 16;
constexpr std::size_t span_queue_places = (std::size_t{1} << hls::span_queue_log2) - hls::span_queue_reserve;
constexpr std::size_t pixel_queue_places = (std::size_t{1} << hls::pixel_queue_log2) - hls::pixel_queue_reserve;
constexpr std::size_t late_pushes = 2;       // at most so many spans are not counted in the span queue yet
constexpr std::size_t pixels_under_way = 5;  // between the span walker and the count of the pixel queue
constexpr Clock queue_to_fetch = 1;          // stream_fifo: from write to fetch, and from fetch to valid
constexpr Clock header_to_verdict = 3;       // packet_decoder: a message waits for it
constexpr Clock first_span_to_load = 2;      // edge_walker: the first span is under way before the next load
constexpr Clock load_to_row = 2;             // edge_walker: state prime
constexpr Clock part_without_rows = 2;       // edge_walker: states skip and prime
constexpr Clock room_to_row = 1;             // edge_walker: a row waits for the room of the clock before
constexpr Clock row_to_queue = 1;            // edge_walker: latency
constexpr Clock pixel_to_output = 7;         // span walker to valid on m_axis

/// The last `places` events of a stage: when was the one that many before the next?
template <std::size_t places>
class History {
 public:
    History() { times_.fill(long_ago); }
    void push(Clock time) {
        times_[next_] = time;
        next_ = (next_ + 1) % places;
    }
    /// The time of the event `back` before the next one, 1…places.
    [[nodiscard]] Clock before_next(std::size_t back) const { return times_[(next_ + places - back) % places]; }

 private:
    std::array<Clock, places> times_{};
    std::size_t next_ = 0;
};

/// One packet, as far as timing goes.
struct Job {
    int beats = 0;
    int message_words = 0;             ///< 0: a triangle
    std::optional<TriangleWalk> walk;  ///< of a triangle
};

/// Calls job(const Job&) for each packet.
template <typename visitor_t>
void for_each_job(const std::vector<std::uint32_t>& packets, int words_per_beat, visitor_t&& visit) {
    for (std::size_t i = 0; i < packets.size();) {
        const PacketHeader header = decode_header(packets[i]);
        const std::size_t count = std::min(packets.size() - i, static_cast<std::size_t>(header.length) + 1);
        Job job;
        job.beats = (static_cast<int>(count) + words_per_beat - 1) / words_per_beat;
        if (header.opcode == hls::opcode_fence && header.length == 0) {
            job.message_words = 1;
        } else if (header.opcode == hls::opcode_query && header.length == 0) {
            job.message_words = hls::query_reply_words;
        } else {
            job.walk = decode_triangle(&packets[i], count).walk;
        }
        visit(job);
        i += count;
    }
}

/// Clocks until a chance of (100 − percent) in 100 comes true, 1 or more.
class Pauses {
 public:
    Pauses(int percent, std::uint32_t seed) : percent_(percent), random_(seed) {}
    Clock next() {
        Clock clocks = 1;
        while (percent_ > 0 && static_cast<int>(random_() % 100) < percent_) ++clocks;
        return clocks;
    }

 private:
    int percent_;
    std::mt19937_64 random_;
};

/// The stages in the order of the data; each method takes one event through its stage and returns its clock.
class Core {
 public:
    explicit Core(const Stalls& stalls)
        : source_(stalls.source_percent, stalls.seed), sink_(stalls.sink_percent, ~stalls.seed) {}

    void run(const Job& job) {
        const Clock ready = decode(job);
        if (job.walk) {
            walk(*job.walk, ready);
        } else {
            answer(job.message_words, ready);
        }
    }

    [[nodiscard]] Clock last_output() const { return output_; }

 private:
    /// Takes one beat through the beat queue into the decoder, not before `ready`; returns when it is accepted.
    Clock accept_beat(Clock ready) {
        const Clock offered = offered_any_ ? written_ + source_.next() : 0;
        offered_any_ = true;
        written_ = std::max(offered, beat_fetches_.before_next(beat_queue_places) + 1);
        const Clock fetched = std::max(written_ + queue_to_fetch, accepted_);
        beat_fetches_.push(fetched);
        accepted_ = std::max({fetched + queue_to_fetch, accepted_ + 1, ready});
        return accepted_;
    }

    /// Takes a packet's beats; returns the first clock in which its job can be taken. The words of a triangle wait
    /// until the job before is taken, the header doesn't.
    Clock decode(const Job& job) {
        const Clock header = accept_beat(header_ready_);
        if (!job.walk) {
            const Clock emitted = std::max(header + header_to_verdict, job_taken_ + 1);
            header_ready_ = emitted + 1;
            return emitted + 1;
        }
        Clock last = header;
        for (int beat = 1; beat < job.beats; ++beat) last = accept_beat(job_taken_ + 1);
        header_ready_ = last + 1;
        return last + 1;
    }

    /// The first clock from `ready` on in which the walker may write the span queue, which it asks for room `ahead` of
    /// the write. Room is counted from registers: the last spans are not in the count yet.
    [[nodiscard]] Clock room_from(Clock ready, Clock ahead) const {
        for (Clock clock = ready;; ++clock) {
            const Clock counted = clock - ahead - 1 - row_to_queue;
            std::size_t uncounted = 0;
            while (uncounted < late_pushes && pushes_.before_next(uncounted + 1) > counted) ++uncounted;
            const Clock freed = span_fetches_.before_next(span_queue_places + uncounted) + 1 + ahead;
            if (freed <= clock) return clock;
            if (uncounted == 0) return freed;
        }
    }

    /// A span through its queue and out, word by word. `decided`: the clock of its row. Returns when its first word
    /// starts.
    Clock push_span(Clock decided, int words) {
        pushes_.push(decided);
        const Clock fetched = std::max(decided + row_to_queue + queue_to_fetch, span_taken_);
        span_fetches_.push(fetched);
        Clock word = std::max(fetched + queue_to_fetch, span_ends_);
        Clock first = 0;
        for (int k = 0; k < words; ++k) {
            // `go` stops the span walker, also before it takes the span.
            word = std::max(word, outputs_.before_next(pixel_queue_places + pixels_under_way));
            if (k == 0) first = word;
            ++word;
            output_ = std::max(word + pixel_to_output, output_ + sink_.next());
            outputs_.push(output_);
        }
        span_taken_ = first;
        span_ends_ = word;
        return first;
    }

    void walk(const TriangleWalk& triangle, Clock ready) {
        job_taken_ = std::max({ready, walker_idle_, first_span_taken_ + first_span_to_load});
        Clock clock = job_taken_ + load_to_row;
        if (triangle.rows_above == 0) clock += part_without_rows;
        bool first = true;
        int carries = 0;
        for_each_row(triangle, [&](const WalkRow& row) {
            // What stands between the row before and this one: its carry, or the middle vertex.
            if (row.carries > carries || (row.row > 0 && row.row == triangle.rows_above)) ++clock;
            carries = row.carries;
            clock = room_from(clock, room_to_row);
            if (row.length > 0) {
                const Clock taken = push_span(clock, row.length);
                if (first) first_span_taken_ = taken;
                first = false;
            }
            ++clock;
        });
        walker_idle_ = clock;
    }

    void answer(int words, Clock ready) {
        job_taken_ = room_from(std::max(ready, walker_idle_), 0);
        push_span(job_taken_, words);
        walker_idle_ = job_taken_ + 1;
    }

    Pauses source_;
    Pauses sink_;
    bool offered_any_ = false;
    Clock written_ = long_ago;
    Clock accepted_ = long_ago;
    Clock header_ready_ = long_ago;
    Clock job_taken_ = long_ago;
    Clock walker_idle_ = long_ago;
    Clock first_span_taken_ = long_ago;
    Clock span_taken_ = long_ago;
    Clock span_ends_ = long_ago;
    Clock output_ = long_ago;
    History<beat_queue_places> beat_fetches_;
    History<late_pushes> pushes_;
    History<span_queue_places + late_pushes> span_fetches_;
    History<pixel_queue_places + pixels_under_way> outputs_;
};

}  // namespace

std::uint64_t CycleBounds::lower() const { return std::max({total.beats, total.walk, total.pixels}); }

CycleBounds cycle_bounds(const std::vector<std::uint32_t>& packets, int words_per_beat) {
    CycleBounds bounds;
    for_each_job(packets, words_per_beat, [&](const Job& job) {
        StageWork work;
        work.beats = static_cast<std::uint64_t>(job.beats);
        work.pixels = static_cast<std::uint64_t>(job.message_words);
        work.walk = 1;
        if (job.walk) {
            work.walk = 2;
            std::uint64_t carries = 0;
            for_each_row(*job.walk, [&](const WalkRow& row) {
                work.walk += 1;
                work.pixels += static_cast<std::uint64_t>(row.length);
                carries = static_cast<std::uint64_t>(row.carries);
            });
            work.walk += carries;
        }
        bounds.total.beats += work.beats;
        bounds.total.walk += work.walk;
        bounds.total.pixels += work.pixels;
        bounds.serial += std::max({work.beats, work.walk, work.pixels});
    });
    return bounds;
}

std::uint64_t predict_cycles(const std::vector<std::uint32_t>& packets, int words_per_beat, const Stalls& stalls) {
    Core core(stalls);
    for_each_job(packets, words_per_beat, [&](const Job& job) { core.run(job); });
    return packets.empty() ? 0 : static_cast<std::uint64_t>(core.last_output()) + 1;
}

}  // namespace sheen
