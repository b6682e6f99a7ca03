// SPDX-License-Identifier: MIT
#include "statements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sheen/error.hpp"

namespace sheen {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

}  // namespace

StatementReader::StatementReader(const std::string& name, std::string_view text, std::string_view format,
                                 std::size_t first_line)
    : name_(name), text_(text), format_(format), line_(first_line) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) {
        text_.remove_prefix(byte_order_mark.size());
    }
}

bool StatementReader::next(std::vector<Word>& words) {
    words.clear();
    while (at_ < text_.size()) {
        if (const std::size_t length = line_end(at_)) {
            at_ += length;
            ++line_;
            if (!words.empty()) {
                return true;
            }
        } else if (text_[at_] == '\\' && line_end(at_ + 1) != 0) {
            at_ += 1 + line_end(at_ + 1);
            ++line_;
        } else if (is_space(text_[at_])) {
            ++at_;
        } else if (text_[at_] == '#') {
            skip([](char) { return true; });
        } else {
            const std::size_t start = at_;
            skip([](char c) { return !is_space(c); });
            words.push_back({text_.substr(start, at_ - start), line_});
        }
    }
    return !words.empty();
}

/// Length of the line end at `position`: 2 for CR LF, 1 for either alone, 0 for none.
std::size_t StatementReader::line_end(std::size_t position) const {
    if (text_.substr(position, 2) == "\r\n") {
        return 2;
    }
    const bool found = position < text_.size() && (text_[position] == '\n' || text_[position] == '\r');
    return found ? 1 : 0;
}

/// Moves past characters that belong, up to the line's end or its continuation mark.
template <typename Belongs>
void StatementReader::skip(Belongs belongs) {
    while (at_ < text_.size() && line_end(at_) == 0 && belongs(text_[at_]) &&
           !(text_[at_] == '\\' && line_end(at_ + 1) != 0)) {
        const auto byte = static_cast<unsigned char>(text_[at_]);
        if (byte < ' ' && !is_space(text_[at_])) {
            throw Error(
                fmt::format("{}:{}: byte 0x{:02x} is no text; Sheen reads {} here", name_, line_, byte, format_));
        }
        ++at_;
    }
}

std::string in_quotes(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string shown(word.substr(0, longest));
    std::replace_if(
        shown.begin(), shown.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + shown + (word.size() > longest ? "...'" : "'");
}

void fail_at(const std::string& name, const Word& word, const std::string& problem) {
    throw Error(fmt::format("{}:{}: {} {}", name, word.line, in_quotes(word.text), problem));
}

double to_number(const std::string& name, const Word& word) {
    std::string_view digits = word.text;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') {
        digits.remove_prefix(1);
    }
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) {
        fail_at(name, word, "is no number");
    }
    if (error == std::errc::result_out_of_range) {
        value = std::strtod(std::string(digits).c_str(), nullptr);
    }
    constexpr double greatest = std::numeric_limits<float>::max();
    return std::abs(value) > greatest ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
}

float to_coordinate(const std::string& name, const Word& word) {
    const double value = to_number(name, word);
    if (!std::isfinite(value)) {
        fail_at(name, word, "is no coordinate; it must be finite and within single precision");
    }
    return static_cast<float>(value);
}

std::string joined_name(const std::vector<Word>& words) {
    std::string name;
    for (std::size_t i = 1; i < words.size(); ++i) {
        name.append(i > 1 ? " " : "").append(words[i].text);
    }
    return name;
}

}  // namespace sheen
