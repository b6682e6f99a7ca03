// SPDX-License-Identifier: MIT
/// \file
/// The node graph of glTF files.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <vector>

#include "gltf_json.hpp"

namespace sheen {

/// A mesh where a node puts it.
struct GltfInstance {
    std::size_t mesh = 0;
    glm::dmat4 to_world{1.0};
};

/// The instances of the default scene, or else of the first; without scenes those of all nodes without a parent.
/// \throws Error that names the field: an index out of range, a node with two parents or in a cycle, a transform that
///         is none, more than 65536 instances.
std::vector<GltfInstance> gltf_instances(const GltfField& root);

}  // namespace sheen
