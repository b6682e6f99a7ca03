// SPDX-License-Identifier: MIT
/// \file
/// Errors of the host library. Each message is one line that names the culprit and what would be right.
#pragma once

#include <stdexcept>
#include <string>

namespace sheen {

/// A failure caused by a file's content or by the system (exit status 1 of the command).
class Error : public std::runtime_error {
 public:
    using std::runtime_error::runtime_error;
};

/// A malformed request: an unknown word or a value out of range (exit status 2 of the command).
class UsageError : public Error {
 public:
    using Error::Error;
};

}  // namespace sheen
