// SPDX-License-Identifier: MIT
/// \file
/// Mesh files made of text: words, statement by statement, and what a message says of a wrong one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sheen {

struct Word {
    std::string_view text;
    std::size_t line = 0;  ///< from 1
};

/// Splits text into statements, which are lines but for continued ones (a backslash before the line end), and those
/// into words. A '#' at a word's start begins a comment; a byte order mark is skipped.
class StatementReader {
 public:
    /// `name` is the file, `format` what it should be ("Wavefront OBJ text"); both must outlive the reader. The text
    /// begins in line `first_line` of the file.
    StatementReader(const std::string& name, std::string_view text, std::string_view format,
                    std::size_t first_line = 1);

    /// Fills `words` with the next statement that has any. False at the end of the text.
    /// \throws Error for a control character.
    bool next(std::vector<Word>& words);

 private:
    [[nodiscard]] std::size_t line_end(std::size_t position) const;
    template <typename Belongs>
    void skip(Belongs belongs);

    const std::string& name_;
    std::string_view text_;
    std::string_view format_;
    std::size_t at_ = 0;
    std::size_t line_;
};

/// A word as a message shows it: in quotes, at most 40 characters, ASCII.
std::string in_quotes(std::string_view word);

/// \throws Error "name:line: 'word' problem".
[[noreturn]] void fail_at(const std::string& name, const Word& word, const std::string& problem);

/// The value of a decimal word; infinite where it is too large for single precision, NaN where it says so.
/// \throws Error as fail_at where it is no number.
double to_number(const std::string& name, const Word& word);

/// A coordinate: finite and within single precision. \throws Error as fail_at.
float to_coordinate(const std::string& name, const Word& word);

/// The words from the second on, a space between them: a name that may hold spaces.
std::string joined_name(const std::vector<Word>& words);

}  // namespace sheen
