// SPDX-License-Identifier: MIT
/// \file
/// A number that counts what is done with it: how methods are priced, by running them instead of by hand. Code that is
/// a template over Real is run with double to draw and with Counted to count.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace sheen {

/// How often each operation was done.
struct OperationCounts {
    std::uint64_t additions = 0;  ///< and subtractions; a change of sign is free
    std::uint64_t multiplications = 0;
    std::uint64_t divisions = 0;
    std::uint64_t roots = 0;        ///< square roots
    std::uint64_t powers = 0;       ///< powers, exponentials, logarithms, trigonometric functions and their inverses
    std::uint64_t comparisons = 0;  ///< for selections, as of a maximum
    std::uint64_t table_reads = 0;
    OperationCounts& operator+=(const OperationCounts& other) {
        additions += other.additions;
        multiplications += other.multiplications;
        divisions += other.divisions;
        roots += other.roots;
        powers += other.powers;
        comparisons += other.comparisons;
        table_reads += other.table_reads;
        return *this;
    }
    friend bool operator==(const OperationCounts& a, const OperationCounts& b) {
        return a.additions == b.additions && a.multiplications == b.multiplications && a.divisions == b.divisions &&
               a.roots == b.roots && a.powers == b.powers && a.comparisons == b.comparisons &&
               a.table_reads == b.table_reads;
    }
};

/// Counts what this thread does with Counted numbers while it lives. Scopes nest: what an inner one counts is the outer
/// one's too, from the inner one's end on. Without a scope nothing is counted.
class CountingScope {
 public:
    CountingScope() : outer_(current()) { current() = this; }
    CountingScope(const CountingScope&) = delete;
    CountingScope& operator=(const CountingScope&) = delete;
    ~CountingScope() {
        current() = outer_;
        if (outer_ != nullptr) outer_->counts_ += counts_;
    }
    [[nodiscard]] const OperationCounts& counts() const { return counts_; }

 private:
    friend class Counted;
    /// The innermost scope of the thread.
    static CountingScope*& current() {
        thread_local CountingScope* scope = nullptr;
        return scope;
    }
    static void count(std::uint64_t OperationCounts::*operation) {
        if (CountingScope* scope = current()) ++(scope->counts_.*operation);
    }

    OperationCounts counts_;
    CountingScope* outer_;
};

/// A double whose operations are counted. Making one from a double is free, as constants are; so is its sign.
/// Uninitialised when made of nothing, as a double is.
class Counted {
 public:
    Counted() = default;
    Counted(double value) : value_(value) {}  // implicit: constants stand beside variables in formulas
    [[nodiscard]] double value() const { return value_; }

    Counted operator-() const { return -value_; }
    Counted& operator+=(Counted b) { return set(&OperationCounts::additions, value_ + b.value_); }
    Counted& operator-=(Counted b) { return set(&OperationCounts::additions, value_ - b.value_); }
    Counted& operator*=(Counted b) { return set(&OperationCounts::multiplications, value_ * b.value_); }
    Counted& operator/=(Counted b) { return set(&OperationCounts::divisions, value_ / b.value_); }
    friend Counted operator+(Counted a, Counted b) { return a += b; }
    friend Counted operator-(Counted a, Counted b) { return a -= b; }
    friend Counted operator*(Counted a, Counted b) { return a *= b; }
    friend Counted operator/(Counted a, Counted b) { return a /= b; }

    friend bool operator<(Counted a, Counted b) { return compared(a.value_ < b.value_); }
    friend bool operator>(Counted a, Counted b) { return compared(a.value_ > b.value_); }
    friend bool operator<=(Counted a, Counted b) { return compared(a.value_ <= b.value_); }
    friend bool operator>=(Counted a, Counted b) { return compared(a.value_ >= b.value_); }
    friend bool operator==(Counted a, Counted b) { return compared(a.value_ == b.value_); }
    friend bool operator!=(Counted a, Counted b) { return compared(a.value_ != b.value_); }

    /// Free: hardware clears a sign bit.
    friend Counted abs(Counted a) { return std::abs(a.value_); }
    friend Counted sqrt(Counted a) { return a.set(&OperationCounts::roots, std::sqrt(a.value_)); }
    friend Counted pow(Counted a, Counted b) { return a.set(&OperationCounts::powers, std::pow(a.value_, b.value_)); }
    friend Counted exp2(Counted a) { return a.set(&OperationCounts::powers, std::exp2(a.value_)); }
    friend Counted exp(Counted a) { return a.set(&OperationCounts::powers, std::exp(a.value_)); }
    friend Counted log2(Counted a) { return a.set(&OperationCounts::powers, std::log2(a.value_)); }
    friend Counted log(Counted a) { return a.set(&OperationCounts::powers, std::log(a.value_)); }
    friend Counted sin(Counted a) { return a.set(&OperationCounts::powers, std::sin(a.value_)); }
    friend Counted cos(Counted a) { return a.set(&OperationCounts::powers, std::cos(a.value_)); }
    friend Counted tan(Counted a) { return a.set(&OperationCounts::powers, std::tan(a.value_)); }
    friend Counted acos(Counted a) { return a.set(&OperationCounts::powers, std::acos(a.value_)); }
    friend Counted atan2(Counted a, Counted b) {
        return a.set(&OperationCounts::powers, std::atan2(a.value_, b.value_));
    }

    /// Counts one read of a table.
    static void count_table_read() { CountingScope::count(&OperationCounts::table_reads); }

 private:
    Counted& set(std::uint64_t OperationCounts::*operation, double result) {
        CountingScope::count(operation);
        value_ = result;
        return *this;
    }
    static bool compared(bool result) {
        CountingScope::count(&OperationCounts::comparisons);
        return result;
    }

    double value_;
};

/// The number itself, for what isn't arithmetic of the method: an index, a decision of the program. Free.
inline double value_of(double x) { return x; }
inline double value_of(Counted x) { return x.value(); }

/// table[index]: one table read where Real counts.
template <typename Real, typename Table>
Real read_table(const Table& table, std::size_t index) {
    if constexpr (std::is_same_v<Real, Counted>) Counted::count_table_read();
    return table[index];
}

}  // namespace sheen
