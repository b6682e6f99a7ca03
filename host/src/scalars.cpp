// SPDX-License-Identifier: MIT
#include "scalars.hpp"

#include <cstring>

namespace sheen {
namespace {

/// The bits of `T`, which has as many as `Raw`, put together from single bytes.
template <typename T, typename Raw>
double load(std::string_view bytes, std::size_t at, ByteOrder order) {
    static_assert(sizeof(T) == sizeof(Raw));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
        const std::size_t from = order == ByteOrder::little ? sizeof(T) - 1 - i : i;
        bits = (bits << 8U) | static_cast<unsigned char>(bytes[at + from]);
    }
    const Raw raw = static_cast<Raw>(bits);
    T value{};
    std::memcpy(&value, &raw, sizeof(value));
    return static_cast<double>(value);
}

}  // namespace

std::size_t size_of(ScalarType type) {
    switch (type) {
        case ScalarType::i8:
        case ScalarType::u8:
            return 1;
        case ScalarType::i16:
        case ScalarType::u16:
            return 2;
        case ScalarType::i32:
        case ScalarType::u32:
        case ScalarType::f32:
            return 4;
        case ScalarType::f64:
            break;
    }
    return 8;
}

double load_scalar(std::string_view bytes, std::size_t at, ScalarType type, ByteOrder order) {
    switch (type) {
        case ScalarType::i8:
            return load<std::int8_t, std::uint8_t>(bytes, at, order);
        case ScalarType::u8:
            return load<std::uint8_t, std::uint8_t>(bytes, at, order);
        case ScalarType::i16:
            return load<std::int16_t, std::uint16_t>(bytes, at, order);
        case ScalarType::u16:
            return load<std::uint16_t, std::uint16_t>(bytes, at, order);
        case ScalarType::i32:
            return load<std::int32_t, std::uint32_t>(bytes, at, order);
        case ScalarType::u32:
            return load<std::uint32_t, std::uint32_t>(bytes, at, order);
        case ScalarType::f32:
            return load<float, std::uint32_t>(bytes, at, order);
        case ScalarType::f64:
            break;
    }
    return load<double, std::uint64_t>(bytes, at, order);
}

void append_u32(std::string& bytes, std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) {
        bytes.push_back(static_cast<char>(static_cast<unsigned char>(value >> shift)));
    }
}

void append_f32(std::string& bytes, float value) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    append_u32(bytes, bits);
}

}  // namespace sheen
