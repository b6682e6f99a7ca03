// SPDX-License-Identifier: MIT
/// \file
/// The rows behind a PLY header, as text or binary.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ply_header.hpp"

namespace sheen {

/// Numbers of the body, one after the other.
class PlyBody {
 public:
    PlyBody() = default;
    PlyBody(const PlyBody&) = delete;
    PlyBody& operator=(const PlyBody&) = delete;
    virtual ~PlyBody() = default;

    /// Enters a row of `element`, counted from 0. \throws Error when the file ends before it.
    virtual void begin_row(const PlyElement& element, std::size_t row) = 0;
    /// The next number of the row. \throws Error when there is none.
    virtual double next(ScalarType type) = 0;
    /// Leaves the row. \throws Error when it has more numbers.
    virtual void end_row() = 0;
    /// What is wrong with the number that next() gave last. \throws Error that names it and where it stands.
    [[noreturn]] virtual void fail(const std::string& problem) const = 0;
};

/// `name` and `bytes`, the whole file, must outlive the body.
std::unique_ptr<PlyBody> make_ply_body(const std::string& name, std::string_view bytes, const PlyHeader& header);

}  // namespace sheen
