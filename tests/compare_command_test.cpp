// SPDX-License-Identifier: MIT
/// \file
/// `sheen compare` as a subprocess: its table, JSON and CSV agree, and it goes on without Python's metrics.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "sheen/method.hpp"
#include "support/command_fixture.hpp"

namespace {

using sheen::all_methods;
using sheen::has_packets;
using sheen::parse_method;
using sheen::test::Outcome;
using sheen::test::Words;

class compare_command : public sheen::test::CommandTest {};

TEST_F(compare_command, writes_a_row_per_method_and_device) {
    const Outcome outcome =
        sheen({"compare", "builtin:sphere-168", "--size", "60x50", "--json", "rows.json", "-o", "sheet.png"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "") << "`make setup` installs what is missing";
    EXPECT_EQ(read("sheet.png").substr(1, 3), "PNG");
    const auto rows = nlohmann::json::parse(read("rows.json"));
    ASSERT_EQ(rows.size(), 2 * all_methods().size());
    for (const auto& row : rows) {
        SCOPED_TRACE(row.dump());
        const bool is_phong = row.at("method") == "phong";
        const bool on_reference = row.at("device") == "reference";
        const bool drawn = on_reference || has_packets(parse_method(row.at("method")));
        EXPECT_EQ(row.count("reason"), drawn ? 0U : 1U);
        EXPECT_EQ(row.at("psnr").is_null(), is_phong || !drawn);
        EXPECT_EQ(row.at("bit_exact").is_null(), on_reference || !drawn);
        EXPECT_TRUE(row.at("cycles").is_null());
        EXPECT_TRUE(row.at("pixels_per_clock").is_null());
        for (const char* key : {"pixels", "triangles", "max_error", "ssim", "flip", "cost"}) {
            EXPECT_EQ(row.at(key).is_null(), !drawn) << key;
        }
        if (!drawn) continue;
        if (is_phong) {
            EXPECT_EQ(row.at("flip"), 0.0) << "phong is the reference itself";
        }
        for (const char* part : {"nodes", "triangle", "span", "pixel"}) {
            EXPECT_EQ(row.at("cost").at(part).size(), 7U) << part;
        }
    }
    EXPECT_NE(outcome.out.find(" inf "), std::string::npos) << outcome.out;
    const auto lines = static_cast<std::size_t>(std::count(outcome.out.begin(), outcome.out.end(), '\n'));
    EXPECT_EQ(lines, 1 + rows.size() + 2 + all_methods().size() + 1) << outcome.out;
}

/// The fields of a line of CSV; quoted ones may hold commas.
Words fields_of(const std::string& line) {
    Words fields(1);
    bool quoted = false;
    for (const char c : line) {
        if (c == '"') {
            quoted = !quoted;
        } else if (c == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

TEST_F(compare_command, writes_as_csv_what_it_writes_as_json) {
    const Outcome outcome = sheen({"compare", "builtin:sphere-168", "--size", "60x50", "--methods",
                                   "gouraud,quadratic,phong", "--json", "rows.json", "--csv", "rows.csv"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto rows = nlohmann::json::parse(read("rows.json"));
    std::istringstream csv(read("rows.csv"));
    std::string line;
    ASSERT_TRUE(std::getline(csv, line));
    const Words names = fields_of(line);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
    for (const auto& row : rows) {
        ASSERT_TRUE(std::getline(csv, line));
        const Words fields = fields_of(line);
        ASSERT_EQ(fields.size(), names.size()) << line;
        for (std::size_t i = 0; i < names.size(); ++i) {
            SCOPED_TRACE(names[i] + " in " + line);
            nlohmann::json value = nullptr;
            if (names[i].rfind("cost_", 0) == 0) {
                const std::size_t split = names[i].find('_', 5);
                if (!row.at("cost").is_null()) {
                    value = row.at("cost").at(names[i].substr(5, split - 5)).at(names[i].substr(split + 1));
                }
            } else if (row.contains(names[i])) {
                value = row.at(names[i]);
            }
            const bool infinite = names[i] == "psnr" && row.at("method") == "phong" && row.at("device") == "reference";
            EXPECT_EQ(fields[i], infinite            ? "inf"
                                 : value.is_null()   ? ""
                                 : value.is_string() ? value.get<std::string>()
                                                     : value.dump());
        }
    }
    EXPECT_FALSE(std::getline(csv, line)) << "more lines than rows";
    EXPECT_NE(std::find(names.begin(), names.end(), "cost_pixel_table_reads"), names.end());
}

TEST_F(compare_command, without_ssim_and_flip_says_so_and_gives_the_rest) {
    const auto rows_of = [this](const Words& more, const std::string& culprit) {
        Words words = {"compare", "good.obj", "--size", "40x30", "--methods", "gouraud", "--json", "rows.json"};
        words.insert(words.end(), more.begin(), more.end());
        const Outcome outcome = sheen(words);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), culprit.empty() ? 0 : 1) << outcome.err;
        EXPECT_NE(outcome.err.find(culprit), std::string::npos) << outcome.err;
        return nlohmann::json::parse(read("rows.json"));
    };
    const auto complete = rows_of({}, "");
    const auto quick = rows_of({"--quick"}, "");
    ASSERT_EQ(::setenv("SHEEN_PYTHON", "no-such-python", 1), 0);
    const auto without = rows_of({}, "no-such-python");
    ::unsetenv("SHEEN_PYTHON");
    EXPECT_EQ(quick, without);
    for (std::size_t i = 0; i < complete.size(); ++i) {
        for (const char* metric : {"ssim", "flip"}) {
            EXPECT_TRUE(complete.at(i).at(metric).is_number());
            EXPECT_TRUE(quick.at(i).at(metric).is_null());
        }
        EXPECT_EQ(complete.at(i).at("psnr"), quick.at(i).at("psnr"));
    }
}

}  // namespace
