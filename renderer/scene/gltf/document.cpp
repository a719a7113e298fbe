// SPDX-License-Identifier: MIT
#include "renderer/scene/gltf/document.h"

#include "renderer/scene/gltf/container.h"
#include "renderer/scene/gltf/draco.h"
#include "renderer/scene/gltf/extensions.h"
#include "renderer/scene/gltf/json_text.h"
#include "renderer/scene/gltf/layout.h"
#include "renderer/scene/gltf/meshopt.h"
#include "renderer/scene/gltf/message.h"
#include "renderer/scene/gltf/model.h"
#include "renderer/scene/gltf/nodes.h"
#include "renderer/scene/gltf/resources.h"
#include "renderer/scene/gltf/schema.h"
#include "renderer/scene/gltf/storage.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tiny_gltf.h>

namespace romascope::gltf {

struct Document::State {
    State(std::string bytes, const std::filesystem::path& path, MemoryBudget& budget)
        : content(std::move(bytes)), resources(path), storage(budget) {}

    void parse();
    void load_buffers();
    void open_views();

    std::string content; ///< the file; the BIN chunk stays in here
    Resources resources;
    Storage storage;
    std::optional<std::span<const std::byte>> binary;
    ParsedModel parsed;
    std::vector<std::optional<std::span<const std::byte>>> buffers; ///< none: without data
    std::vector<std::string> notices;
};

/// Up to the model, with everything checked that can be without looking into buffers.
void Document::State::parse() {
    /// Upper bound of what tinygltf keeps for a JSON object, materials apart.
    constexpr size_t kPerObject = 1024;
    storage.take(content.size(), 1, "the file");
    const Container parts = split_container(content);
    binary = parts.binary;
    const JsonSize size = measure_json(parts.json);
    storage.take(size.objects, kPerObject, "the JSON part");
    // We and tinygltf parse it once each, with the text for tinygltf in between.
    {
        const Loan working(storage.budget(), 2 * size.bytes + parts.json.size(), 1,
                           "the JSON part");
        nlohmann::json file = parse_json(parts.json);
        check_versions(file, notices);
        check_schema(file);
        parsed = read_model(std::move(file), storage);
    }
    std::vector<size_t> sizes;
    for (const BufferSource& buffer : parsed.buffers)
        sizes.push_back(buffer.size);
    check_layout(parsed.model, sizes);
    check_nodes(parsed.model);
}

/// All buffers but those that only stand in for what we decode. A buffer without a URI may stay
/// without data as long as nobody reads it.
void Document::State::load_buffers() {
    std::vector<bool> needed(parsed.buffers.size());
    for (size_t i = 0; i < needed.size(); ++i)
        needed[i] = !parsed.buffers[i].fallback;
    for (size_t i = 0; i < parsed.model.bufferViews.size(); ++i)
        needed[static_cast<size_t>(source_buffer(parsed.model, i))] = true;
    buffers.resize(parsed.buffers.size());
    for (size_t i = 0; i < buffers.size(); ++i) {
        BufferSource& source = parsed.buffers[i];
        const std::string element = fmt::format("buffers[{}]", i);
        if (!needed[i])
            continue;
        if (!source.uri.empty()) {
            const size_t before = storage.budget().taken();
            auto bytes =
                resources.read(source.uri, source.size, storage.budget(), element + ".uri");
            storage.adopt(storage.budget().taken() - before);
            buffers[i] = storage.keep(std::move(bytes));
            source.uri = {};
        } else if (i == 0 && binary) {
            if (binary->size() < source.size)
                refuse(element + ".byteLength", fmt::format("{}, but the BIN chunk has {} bytes",
                                                            source.size, binary->size()));
            buffers[i] = *binary;
        }
    }
}

void Document::State::open_views() {
    const auto& views = parsed.model.bufferViews;
    storage.views.resize(views.size());
    for (size_t i = 0; i < views.size(); ++i)
        if (const auto& buffer = buffers[static_cast<size_t>(views[i].buffer)])
            storage.views[i] = buffer->subspan(views[i].byteOffset, views[i].byteLength);
    decode_meshopt(parsed.model, buffers, storage);
    for (size_t i = 0; i < parsed.model.accessors.size(); ++i) {
        const int view = parsed.model.accessors[i].bufferView;
        if (view >= 0 && !storage.views[static_cast<size_t>(view)])
            refuse(fmt::format("accessors[{}].bufferView", i),
                   fmt::format("reads buffers[{}], which has no data",
                               views[static_cast<size_t>(view)].buffer));
    }
    resolve_sparse(parsed.model, storage);
    decode_draco(parsed.model, storage);
}

Document::Document(std::string content, const std::filesystem::path& path, MemoryBudget& budget)
    : state_(std::make_unique<State>(std::move(content), path, budget)) {
    try {
        state_->parse();
        state_->load_buffers();
        state_->open_views();
    } catch (const std::bad_alloc&) {
        refuse("glTF", "there is not enough memory for it");
    }
}

Document::~Document() = default;

const tinygltf::Model& Document::model() const { return state_->parsed.model; }

std::span<const std::byte> Document::view(int index) const {
    const auto& view = state_->storage.views[static_cast<size_t>(index)];
    if (!view)
        refuse(fmt::format("bufferViews[{}]", index), "its buffer has no data");
    return *view;
}

std::vector<std::byte> Document::image(int index) const {
    const tinygltf::Image& image = model().images[static_cast<size_t>(index)];
    const std::string element = fmt::format("images[{}]", index);
    MemoryBudget& budget = state_->storage.budget();
    if (image.bufferView < 0)
        return state_->resources.read(image.uri, std::nullopt, budget, element + ".uri");
    const auto bytes = view(image.bufferView);
    budget.take(bytes.size(), 1, element);
    return {bytes.begin(), bytes.end()};
}

const std::vector<std::string>& Document::notices() const { return state_->notices; }

} // namespace romascope::gltf
