// SPDX-License-Identifier: MIT
#include "comparison_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <vector>

#include "output.hpp"

namespace sheen::command {
namespace {

template <typename Number>
std::string number_or_dash(const std::optional<Number>& value, const char* format) {
    return value ? fmt::format(fmt::runtime(format), *value) : "-";
}

std::string table_row(const ComparisonRow& row) {
    const std::string names = fmt::format("{:<13} {:<10} ", to_string(row.method), row.device);
    if (!row.reason.empty()) {
        return names + row.reason + "\n";
    }
    const std::string bit_exact = row.bit_exact ? (*row.bit_exact ? "yes" : "no") : "-";
    return names + fmt::format("{:>7.2f} {:>9.2f} {:>7} {:>7} {:>9} {:>9} {:>9} {:>10} {:>16}\n", row.psnr,
                               row.max_error, number_or_dash(row.ssim, "{:.4f}"), number_or_dash(row.flip, "{:.4f}"),
                               bit_exact, row.triangles, row.pixels, number_or_dash(row.cycles, "{}"),
                               number_or_dash(row.pixels_per_clock(), "{:.3f}"));
}

/// As in 7.5/18/1/1/1/0; comparisons are left to JSON and CSV.
std::string short_counts(const MeanCounts& counts) {
    std::vector<std::string> words;
    for (const double count : {counts.additions, counts.multiplications, counts.divisions, counts.roots, counts.powers,
                               counts.table_reads}) {
        words.push_back(fmt::format("{:.4g}", std::round(count * 10.0) / 10.0));
    }
    return fmt::format("{}", fmt::join(words, "/"));
}

/// Each method's cost once, whatever the devices.
std::string cost_table(const Comparison& comparison) {
    std::string lines;
    const Method* last = nullptr;
    for (const ComparisonRow& row : comparison.rows) {
        if (!row.cost || (last != nullptr && *last == row.method)) continue;
        last = &row.method;
        lines += fmt::format("{:<13}", to_string(row.method));
        for (const auto& [part, counts] : row.cost->named()) lines += fmt::format(" {:>24}", short_counts(counts));
        lines += "\n";
    }
    if (lines.empty()) return lines;
    return fmt::format("\n{:<13} {:>24} {:>24} {:>24} {:>24}\n", "cost (+*/r^t)", "nodes a triangle", "triangle",
                       "span", "pixel") +
           lines + "+ additions, * multiplications, / divisions, r roots, ^ powers, t table reads\n";
}

nlohmann::ordered_json to_json(const MethodCost& cost) {
    nlohmann::ordered_json json;
    for (const auto& [part, counts] : cost.named()) {
        for (const auto& [operation, count] : counts.named()) json[part][operation] = count;
    }
    return json;
}

nlohmann::ordered_json to_json(const ComparisonRow& row) {
    nlohmann::ordered_json json = {{"method", to_string(row.method)}, {"device", row.device}};
    const bool drawn = row.reason.empty();
    const auto figure = [drawn](const auto& value) { return drawn ? nlohmann::ordered_json(value) : nullptr; };
    json["psnr"] = std::isinf(row.psnr) ? nullptr : figure(row.psnr);
    json["max_error"] = figure(row.max_error);
    json["ssim"] = json_or_null(row.ssim);
    json["flip"] = json_or_null(row.flip);
    json["bit_exact"] = json_or_null(row.bit_exact);
    json["triangles"] = figure(row.triangles);
    json["pixels"] = figure(row.pixels);
    json["cycles"] = json_or_null(row.cycles);
    json["pixels_per_clock"] = json_or_null(row.pixels_per_clock());
    json["cost"] = row.cost ? to_json(*row.cost) : nlohmann::ordered_json(nullptr);
    if (!drawn) {
        json["reason"] = row.reason;
    }
    return json;
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_field(const nlohmann::ordered_json& value) {
    if (value.is_null()) return "";
    return csv_field(value.is_string() ? value.get<std::string>() : value.dump());
}

}  // namespace

std::string comparison_table(const Comparison& comparison) {
    std::string text = fmt::format("{:<13} {:<10} {:>7} {:>9} {:>7} {:>7} {:>9} {:>9} {:>9} {:>10} {:>16}\n", "method",
                                   "device", "psnr", "max_error", "ssim", "flip", "bit_exact", "triangles", "pixels",
                                   "cycles", "pixels_per_clock");
    for (const ComparisonRow& row : comparison.rows) {
        text += table_row(row);
    }
    return text + cost_table(comparison);
}

nlohmann::ordered_json comparison_json(const Comparison& comparison) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const ComparisonRow& row : comparison.rows) {
        rows.push_back(to_json(row));
    }
    return rows;
}

std::string comparison_csv(const Comparison& comparison) {
    std::vector<std::string> names;
    std::string lines;
    for (const ComparisonRow& row : comparison.rows) {
        nlohmann::ordered_json json = to_json(row);
        json.erase("cost");
        json["reason"] = row.reason;
        if (row.reason.empty() && std::isinf(row.psnr)) json["psnr"] = "inf";
        for (const auto& [part, counts] : row.cost.value_or(MethodCost{}).named()) {
            for (const auto& [operation, count] : counts.named()) {
                json[fmt::format("cost_{}_{}", part, operation)] =
                    row.cost ? nlohmann::ordered_json(count) : nlohmann::ordered_json(nullptr);
            }
        }
        std::vector<std::string> fields;
        const bool first = names.empty();
        for (const auto& [name, value] : json.items()) {
            if (first) names.push_back(name);
            fields.push_back(csv_field(value));
        }
        lines += fmt::format("{}\n", fmt::join(fields, ","));
    }
    return fmt::format("{}\n", fmt::join(names, ",")) + lines;
}

}  // namespace sheen::command
