// SPDX-License-Identifier: MIT
/// \file
/// The words of Wavefront OBJ text, statement by statement.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "sheen/error.hpp"

namespace sheen {

struct Word {
    std::string_view text;
    std::size_t line = 0;
};

/// Splits text into statements, which are lines but for continued ones, and those into words.
class StatementReader {
 public:
    StatementReader(const std::string& name, std::string_view text) : name_(name), text_(text) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (text_.substr(0, byte_order_mark.size()) == byte_order_mark) {
            text_.remove_prefix(byte_order_mark.size());
        }
    }

    /// Fills `words` with the next statement that has any. False at the end of the text.
    bool next(std::vector<Word>& words) {
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

 private:
    static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

    /// Length of the line end at `position`: 2 for CR LF, 1 for either alone, 0 for none.
    [[nodiscard]] std::size_t line_end(std::size_t position) const {
        if (text_.substr(position, 2) == "\r\n") {
            return 2;
        }
        const bool found = position < text_.size() && (text_[position] == '\n' || text_[position] == '\r');
        return found ? 1 : 0;
    }

    /// Moves past characters that belong, up to the line's end or its continuation mark.
    template <typename Belongs>
    void skip(Belongs belongs) {
        while (at_ < text_.size() && line_end(at_) == 0 && belongs(text_[at_]) &&
               !(text_[at_] == '\\' && line_end(at_ + 1) != 0)) {
            const auto byte = static_cast<unsigned char>(text_[at_]);
            if (byte < ' ' && !is_space(text_[at_])) {
                throw Error(fmt::format("{}:{}: byte 0x{:02x} is no text; Sheen reads Wavefront OBJ text files", name_,
                                        line_, byte));
            }
            ++at_;
        }
    }

    const std::string& name_;
    std::string_view text_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
};

}  // namespace sheen
