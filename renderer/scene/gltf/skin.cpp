// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/skin.h"

#include "renderer/scene/gltf/accessor.h"
#include "renderer/scene/gltf/numbers.h"

#include <tiny_gltf.h>

namespace romascope::gltf {
namespace {

const AccessorKind kJoints = {
    TINYGLTF_TYPE_VEC4,
    {TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT}};
const AccessorKind kWeights = {TINYGLTF_TYPE_VEC4,
                               {TINYGLTF_COMPONENT_TYPE_FLOAT,
                                TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE,
                                TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT}};

/// A bind matrix is a transform: its last row, which rounding may have touched, is 0 0 0 1.
glm::dmat4 affine(glm::mat4 matrix, const std::string& element) {
    for (int column = 0; column < 4; ++column) {
        const float expected = column == 3 ? 1.0f : 0.0f;
        if (std::abs(matrix[column][3] - expected) > 1e-4f)
            refuse(element, "is not affine: its last row must be 0 0 0 1");
        matrix[column][3] = expected;
        for (int row = 0; row < 3; ++row)
            if (std::abs(matrix[column][row]) > kMaxCoordinate)
                refuse(element, fmt::format("has a number beyond {}", kMaxCoordinate));
    }
    return glm::dmat4(matrix);
}

} // namespace

std::vector<Skin> read_skins(const Document& document, const Hierarchy& hierarchy,
                             MemoryBudget& budget) {
    const tinygltf::Model& model = document.model();
    std::vector<Skin> skins;
    for (size_t s = 0; s < model.skins.size(); ++s) {
        const tinygltf::Skin& source = model.skins[s];
        const std::string element = fmt::format("skins[{}]", s);
        if (source.joints.empty())
            refuse(element + ".joints", "is empty");
        if (source.joints.size() > 65536)
            refuse(element + ".joints", "more than 65536 joints cannot be told apart");
        budget.take(source.joints.size(), sizeof(glm::dmat4) + sizeof(uint32_t), element);
        Skin skin;
        for (const int joint : source.joints)
            skin.joints.push_back(hierarchy.place[static_cast<size_t>(joint)]);
        skin.inverse_bind.resize(skin.joints.size(), glm::dmat4(1.0));
        if (source.inverseBindMatrices >= 0) {
            const std::string name = element + ".inverseBindMatrices";
            const AccessorReader reader(document, source.inverseBindMatrices,
                                        {TINYGLTF_TYPE_MAT4, {TINYGLTF_COMPONENT_TYPE_FLOAT}},
                                        name);
            if (reader.count() < skin.joints.size())
                refuse(name, fmt::format("{} matrices for {} joints", reader.count(),
                                         skin.joints.size()));
            for (size_t i = 0; i < skin.joints.size(); ++i)
                skin.inverse_bind[i] =
                    affine(reader.mat4(i), fmt::format("{}: element {}", name, i));
        }
        skins.push_back(std::move(skin));
    }
    return skins;
}

InfluenceAccessors influence_accessors(const tinygltf::Model& model, size_t mesh,
                                       size_t primitive) {
    const auto& attributes = model.meshes[mesh].primitives[primitive].attributes;
    InfluenceAccessors found;
    for (int set = 0;; ++set) {
        const auto joints = attributes.find(fmt::format("JOINTS_{}", set));
        const auto weights = attributes.find(fmt::format("WEIGHTS_{}", set));
        if ((joints == attributes.end()) != (weights == attributes.end()))
            refuse(fmt::format("meshes[{}].primitives[{}].attributes", mesh, primitive),
                   fmt::format("only one of JOINTS_{} and WEIGHTS_{} is there", set, set));
        if (joints == attributes.end())
            return found;
        found.joints.push_back(joints->second);
        found.weights.push_back(weights->second);
    }
}

std::vector<Influence> read_influences(const Document& document, const InfluenceAccessors& from,
                                       const std::vector<uint32_t>& sources, size_t vertex_count,
                                       const Skin& skin, const std::string& element,
                                       Notices& notices) {
    const size_t sets = from.joints.size();
    std::vector<Influence> influences(sources.size() * sets);
    std::vector<double> sums(sources.size(), 0.0);
    for (size_t set = 0; set < sets; ++set) {
        const std::string joint_name = fmt::format("{}.attributes.JOINTS_{}", element, set);
        const std::string weight_name = fmt::format("{}.attributes.WEIGHTS_{}", element, set);
        const AccessorReader joints(document, from.joints[set], kJoints, joint_name);
        const AccessorReader weights(document, from.weights[set], kWeights, weight_name);
        for (const auto& [reader, name] :
             {std::pair(&joints, &joint_name), std::pair(&weights, &weight_name)})
            if (reader->count() != vertex_count)
                refuse(*name,
                       fmt::format("{} elements for {} vertices", reader->count(), vertex_count));
        for (size_t i = 0; i < sources.size(); ++i) {
            Influence& influence = influences[i * sets + set];
            for (int k = 0; k < 4; ++k) {
                const uint32_t joint = joints.integer(sources[i], k);
                const float weight = weights.number(sources[i], k);
                if (joint >= skin.joints.size())
                    refuse(joint_name, fmt::format("element {} names joint {}, there are {}",
                                                   sources[i], joint, skin.joints.size()));
                if (weight < 0.0f || weight > 1e6f)
                    refuse(weight_name,
                           fmt::format("element {} is not a weight between 0 and 1", sources[i]));
                influence.joint[k] = static_cast<uint16_t>(joint);
                influence.weight[k] = weight;
                sums[i] += weight;
            }
        }
    }
    for (size_t i = 0; i < sources.size(); ++i) {
        if (!(sums[i] > 1e-6)) {
            notices.add(element, "vertices without weights follow the first joint");
            for (size_t set = 0; set < sets; ++set)
                influences[i * sets + set] = {};
            influences[i * sets].weight[0] = 1.0f;
            continue;
        }
        for (size_t set = 0; set < sets; ++set)
            for (float& weight : influences[i * sets + set].weight)
                weight = static_cast<float>(weight / sums[i]);
    }
    return influences;
}

} // namespace romascope::gltf
