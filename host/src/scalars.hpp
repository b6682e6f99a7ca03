// SPDX-License-Identifier: MIT
/// \file
/// Numbers in binary mesh files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sheen {

enum class ScalarType { i8, u8, i16, u16, i32, u32, f32, f64 };
enum class ByteOrder { little, big };

/// Bytes of a value: 1 to 8.
std::size_t size_of(ScalarType type);

/// The value at byte `at`; every type's values are exact in double. \pre at + size_of(type) <= bytes.size()
double load_scalar(std::string_view bytes, std::size_t at, ScalarType type, ByteOrder order = ByteOrder::little);

/// Appends four bytes, the lowest first.
void append_u32(std::string& bytes, std::uint32_t value);
void append_f32(std::string& bytes, float value);

}  // namespace sheen
