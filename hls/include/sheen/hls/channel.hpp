// SPDX-License-Identifier: MIT
/// \file
/// channel<T>: the streams of a top, ac_channel by another name. HLS tools replace ac_channel by a port of their own.
///
/// Elsewhere ac_channel is a software queue that allocates. scripts/check_synthesizable.py, which reads the code that
/// becomes hardware, defines SHEEN_CHANNEL_PORTS and sees the port's registers in its place.
#pragma once

#ifdef SHEEN_CHANNEL_PORTS

namespace sheen::hls {

template <typename T>
class channel {
 public:
    bool nb_read(T& value) {
        if (valid_) value = data_;
        const bool was_valid = valid_;
        valid_ = false;
        return was_valid;
    }
    void write(const T& value) {
        data_ = value;
        valid_ = true;
    }

 private:
    T data_;
    volatile bool valid_;
};

}  // namespace sheen::hls

#else

#include <ac_channel.h>

namespace sheen::hls {

template <typename T>
using channel = ac_channel<T>;

}  // namespace sheen::hls

#endif
