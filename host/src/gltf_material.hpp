// SPDX-License-Identifier: MIT
/// \file
/// Materials of glTF files.
#pragma once

#include "gltf_json.hpp"
#include "sheen/lighting.hpp"

namespace sheen {

/// Blinn's material for glTF's metallic-roughness one, of which the factors count, not the textures.
///
/// kd is the base colour, whatever the metalness. A microfacet distribution of roughness r (its slope r², as glTF
/// defines it) is nearest to a Blinn exponent n = 2/r⁴ − 2, at most 1000. ks = 0.04·(n + 8)/8, at most 1: a dielectric
/// reflects 4 %, and a narrow highlight is the brighter for its width. ka is Sheen's default.
/// \throws Error that names the field: a factor that isn't in 0…1.
Material gltf_material(const GltfField& material);

/// glTF's own default: white, roughness 1.
Material gltf_default_material();

}  // namespace sheen
