// SPDX-License-Identifier: MIT
#include "renderer/reuse/spatial_hash/table_model.h"

namespace romascope {

TableModel::TableModel(uint32_t capacity, HashProbing probing, int search_count)
    : cells_(capacity), probing_(static_cast<int>(probing)), search_count_(search_count) {}

uint32_t TableModel::slot(const HashedKey& key, int probe) const {
    return gpu::probe_slot(key.hash, probe, probing_, static_cast<uint32_t>(cells_.size()) - 1);
}

gpu::Search TableModel::step(const gpu::Search& search, const HashedKey& key) {
    uint32_t& checksum = cells_[slot(key, search.probe)].checksum;
    const uint32_t seen = checksum;
    if (search.claims == 1 && seen == 0)
        checksum = key.checksum;
    return gpu::search_next(search, seen, key.checksum, search_count_);
}

gpu::Search TableModel::step(const gpu::Search& search, const HashedKey& key, uint32_t load) const {
    return gpu::search_next(search, load, key.checksum, search_count_);
}

void TableModel::settle(uint32_t frame, uint32_t max_age) {
    for (gpu::Cell& cell : cells_)
        cell = gpu::settled_cell(cell, frame, max_age);
}

uint32_t TableModel::find_or_claim(const HashedKey& key) {
    gpu::Search search = gpu::search_begin();
    for (int i = 0; i < gpu::search_limit(search_count_); ++i) {
        const uint32_t at = slot(key, search.probe);
        search = step(search, key);
        if (search.state == gpu::kSearchFound || search.state == gpu::kSearchClaimed)
            return at;
        if (search.state == gpu::kSearchFailed)
            break;
    }
    return gpu::kNoSlot;
}

} // namespace romascope
