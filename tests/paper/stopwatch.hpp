// SPDX-License-Identifier: MIT
/// \file
/// Processor time of a method's loop: medians of repetitions, taken in turns so that a change of clock meets all alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sheen/loop.hpp"

namespace sheen::paper {

/// A scene with its triangles and their rows, ready to be shaded.
struct Workload {
    explicit Workload(Scene scene_);
    Scene scene;
    std::vector<ScreenTriangle> triangles;
    std::vector<std::vector<PixelRow>> rows;  ///< of each triangle
    double pixels = 0.0;
};

/// Seconds for all triangles of a workload.
struct Times {
    double setup = 0.0;  ///< what is done once a triangle
    double whole = 0.0;  ///< all
};

/// A method at work on a workload, which must outlive it.
struct Contestant {
    std::string name;
    Method method;
    const Workload* workload;
    MethodOptions options = {};
};

/// Medians over `repetitions`, in the order of the contestants. Colours are made in double, and added up instead of
/// stored. The exponent table's making is left out. Time is the thread's processor time, so that other programs matter
/// less.
std::vector<Times> race(const std::vector<Contestant>& contestants, int repetitions);

/// The median of the seconds that `work` takes; what it returns must be a number.
double median_seconds(int repetitions, const std::function<double()>& work);

}  // namespace sheen::paper
