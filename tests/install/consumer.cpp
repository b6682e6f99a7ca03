// SPDX-License-Identifier: MIT
/// \file
/// Uses the installed library: counts a built-in mesh's triangles and asks the kernels for their formats.
/// Prints both; exit status 1 when either is not what sheen documents.
#include <cstdio>

#include "sheen/device.hpp"
#include "sheen/hls/formats.hpp"
#include "sheen/mesh.hpp"

int main() {
    const sheen::Mesh mesh = sheen::load_mesh("builtin:sphere-168");
    const auto device = sheen::make_device("hls");
    const sheen::Capabilities capabilities = sheen::query_capabilities(*device);
    std::printf("%zu triangles; device %s, protocol %d\n", mesh.triangles.size(), device->name().c_str(),
                capabilities.protocol_version);
    const bool as_documented =
        mesh.triangles.size() == 168 && capabilities.protocol_version == sheen::hls::protocol_version;
    return as_documented ? 0 : 1;
}
