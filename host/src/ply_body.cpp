// SPDX-License-Identifier: MIT
#include "ply_body.hpp"

#include <fmt/format.h>

#include "sheen/error.hpp"
#include "statements.hpp"

namespace sheen {
namespace {

/// A row is a line.
class TextBody : public PlyBody {
 public:
    TextBody(const std::string& name, std::string_view text, std::size_t first_line)
        : name_(name), reader_(name, text, "PLY text", first_line) {}

    void begin_row(const PlyElement& element, std::size_t row) override {
        if (!reader_.next(words_)) {
            throw Error(fmt::format("{}: the file ends before row {} of the {} of element {}", name_, row + 1,
                                    element.count, in_quotes(element.name)));
        }
        used_ = 0;
    }

    double next(ScalarType /*type*/) override {
        if (used_ == words_.size()) {
            fail_at(name_, words_.back(), "is the last number of a row that needs more; the header lists them");
        }
        return to_number(name_, words_[used_++]);
    }

    void end_row() override {
        if (used_ != words_.size()) {
            fail_at(name_, words_[used_], "is one number more than the header lists for the row");
        }
    }

    [[noreturn]] void fail(const std::string& problem) const override { fail_at(name_, words_[used_ - 1], problem); }

 private:
    const std::string& name_;
    StatementReader reader_;
    std::vector<Word> words_;
    std::size_t used_ = 0;
};

class BinaryBody : public PlyBody {
 public:
    BinaryBody(const std::string& name, std::string_view bytes, ByteOrder order)
        : name_(name), bytes_(bytes), order_(order) {}

    void begin_row(const PlyElement& element, std::size_t row) override {
        element_ = &element;
        row_ = row;
    }

    double next(ScalarType type) override {
        if (bytes_.size() - at_ < size_of(type)) {
            throw Error(fmt::format("{}: the file ends in row {} of the {} of element {}", name_, row_ + 1,
                                    element_->count, in_quotes(element_->name)));
        }
        last_ = load_scalar(bytes_, at_, type, order_);
        at_ += size_of(type);
        return last_;
    }

    void end_row() override {}

    [[noreturn]] void fail(const std::string& problem) const override {
        throw Error(fmt::format("{}: row {} of element {}: '{}' {}", name_, row_ + 1, in_quotes(element_->name), last_,
                                problem));
    }

 private:
    const std::string& name_;
    std::string_view bytes_;
    ByteOrder order_;
    const PlyElement* element_ = nullptr;
    std::size_t row_ = 0;
    std::size_t at_ = 0;
    double last_ = 0.0;
};

}  // namespace

std::unique_ptr<PlyBody> make_ply_body(const std::string& name, std::string_view bytes, const PlyHeader& header) {
    const std::string_view body = bytes.substr(header.size);
    if (header.binary) {
        return std::make_unique<BinaryBody>(name, body, *header.binary);
    }
    return std::make_unique<TextBody>(name, body, header.lines + 1);
}

}  // namespace sheen
