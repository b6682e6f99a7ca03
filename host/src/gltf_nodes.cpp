// SPDX-License-Identifier: MIT
#include "gltf_nodes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <utility>

namespace sheen {
namespace {

constexpr std::size_t max_instances = 65536;

/// The numbers of an array of length `size`.
std::vector<double> numbers(const GltfField& array, std::size_t size) {
    if (array.size() != size) {
        array.fail(fmt::format("has {} numbers; it needs {}", array.size(), size));
    }
    std::vector<double> result;
    for (std::size_t i = 0; i < size; ++i) {
        result.push_back(array[i].number());
    }
    return result;
}

/// A node's own transform: its matrix, column by column, or scale, then rotation (quaternion x, y, z, w), then
/// translation.
glm::dmat4 local_transform(const GltfField& node) {
    glm::dmat4 result(1.0);
    if (node.has("matrix")) {
        const std::vector<double> values = numbers(node["matrix"], 16);
        for (std::size_t i = 0; i < values.size(); ++i) {
            result[static_cast<int>(i / 4)][static_cast<int>(i % 4)] = values[i];
        }
        if (result[0][3] != 0.0 || result[1][3] != 0.0 || result[2][3] != 0.0 || result[3][3] != 1.0) {
            node["matrix"].fail("is no affine transform; its last row must be 0, 0, 0, 1");
        }
        return result;
    }
    if (node.has("translation")) {
        const std::vector<double> v = numbers(node["translation"], 3);
        result = glm::translate(result, glm::dvec3(v[0], v[1], v[2]));
    }
    if (node.has("rotation")) {
        const std::vector<double> q = numbers(node["rotation"], 4);
        const glm::dquat rotation(q[3], q[0], q[1], q[2]);
        constexpr double tolerance = 1e-2;
        if (!(std::abs(glm::length(rotation) - 1.0) <= tolerance)) {
            node["rotation"].fail("is no rotation; it must be a quaternion of length 1");
        }
        result = result * glm::mat4_cast(glm::normalize(rotation));
    }
    if (node.has("scale")) {
        const std::vector<double> v = numbers(node["scale"], 3);
        result = glm::scale(result, glm::dvec3(v[0], v[1], v[2]));
    }
    return result;
}

bool within_single_precision(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!(std::abs(m[column][row]) <= std::numeric_limits<float>::max())) {
                return false;
            }
        }
    }
    return true;
}

/// Walks the graph with a stack of its own, since a file may nest its nodes as deep as it likes.
class Walk {
 public:
    explicit Walk(const GltfField& root) : nodes_(root["nodes"]), visited_(nodes_.size(), false) {}

    /// Adds the nodes that the array names, and all below them.
    void add(const GltfField& indices, const glm::dmat4& parent) {
        for (std::size_t i = 0; i < indices.size(); ++i) {
            pending_.emplace_back(visit(indices[i]), parent);
        }
    }

    /// Adds the nodes that no other has as a child.
    void add_roots() {
        std::vector<bool> is_child(nodes_.size(), false);
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const GltfField node = nodes_[i];
            for (std::size_t k = 0; node.has("children") && k < node["children"].size(); ++k) {
                is_child.at(existing(node["children"][k])) = true;
            }
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            if (!is_child[i]) {
                visited_[i] = true;
                pending_.emplace_back(i, glm::dmat4(1.0));
            }
        }
        if (pending_.empty()) {
            nodes_.fail("each node is a child of another, in a cycle; at least one must have no parent");
        }
    }

    std::vector<GltfInstance> instances() {
        std::vector<GltfInstance> result;
        while (!pending_.empty()) {
            const auto [index, parent] = pending_.back();
            pending_.pop_back();
            const GltfField node = nodes_[index];
            const glm::dmat4 to_world = parent * local_transform(node);
            if (!within_single_precision(to_world)) {
                node.fail("its transform leaves single precision");
            }
            if (node.has("mesh")) {
                if (result.size() == max_instances) {
                    node.fail(fmt::format("one node with a mesh more than {}, the most of a file", max_instances));
                }
                result.push_back({node["mesh"].whole(), to_world});
            }
            if (node.has("children")) {
                add(node["children"], to_world);
            }
        }
        return result;
    }

 private:
    [[nodiscard]] std::size_t existing(const GltfField& index) const {
        if (index.whole() >= nodes_.size()) {
            index.fail(fmt::format("is {}; the file has {} nodes, counted from 0", index.whole(), nodes_.size()));
        }
        return index.whole();
    }

    std::size_t visit(const GltfField& index) {
        const std::size_t node = existing(index);
        if (visited_[node]) {
            index.fail(fmt::format("reaches node {} a second time; nodes have one parent and no cycles", node));
        }
        visited_[node] = true;
        return node;
    }

    GltfField nodes_;
    std::vector<bool> visited_;
    std::vector<std::pair<std::size_t, glm::dmat4>> pending_;
};

}  // namespace

std::vector<GltfInstance> gltf_instances(const GltfField& root) {
    Walk walk(root);
    if (root.has("scenes") && root["scenes"].size() > 0) {
        const GltfField scene = root["scenes"][root.whole("scene", 0)];
        if (scene.has("nodes")) {
            walk.add(scene["nodes"], glm::dmat4(1.0));
        }
    } else {
        walk.add_roots();
    }
    return walk.instances();
}

}  // namespace sheen
