// SPDX-License-Identifier: MIT
/// \file
/// Subdivision options, checked where they are read.
#include "subdivide_options.hpp"

#include "sheen/error.hpp"
#include "values.hpp"

namespace sheen::command {

SubdivideOptions::SubdivideOptions(CLI::App& command) {
    constexpr const char* group = "Subdivision";
    const auto add = [&command](const char* name, const char* words, const char* description, auto store) {
        command.add_option_function<std::string>(name, store, description)->type_name(words)->group(group);
    };
    add("--subdivide", "STEPS", "Split triangles that err by more, in 8-bit steps: gouraud, quadratic, log-quadratic",
        [this](const std::string& word) {
            tolerance_ = parse_number("--subdivide", word, not_negative);
            if (*tolerance_ == 0.0) throw UsageError("--subdivide '" + word + "': give a number above 0");
        });
    add("--subdivide-test", "T", "Where errors are looked for: centre (the paper's) or edge, without cracks [edge]",
        [this](const std::string& word) { test_ = parse_subdivision_test(word); });
}

std::optional<Subdivision> SubdivideOptions::subdivision() const {
    if (!tolerance_) {
        if (test_) throw UsageError("--subdivide-test: give --subdivide STEPS too");
        return std::nullopt;
    }
    Subdivision result;
    result.tolerance = *tolerance_;
    result.test = test_.value_or(result.test);
    return result;
}

}  // namespace sheen::command
