// SPDX-License-Identifier: MIT
#pragma once

#include "renderer/settings/settings.h"

#include <vector>

namespace romascope {

/// As kProbeLinear, ... in shaders/reuse/spatial_hash/search.h.
enum class HashProbing { linear, rehash, bucket };

/// Views of the hash from the camera.
enum class HashView { cell, samples, age, failed };

inline constexpr const char* kHashArticle =
    "Anagnostou, Spatial hashing for raytraced ambient occlusion";

inline const Knob<bool> kHashEnabled{
    {.key = "hash.enabled",
     .unit = "",
     .help = "Keep ambient occlusion in cells of a spatial hash, which stays when the camera moves "
             "and saves the rays of cells that have enough.",
     .source = "off: one frame of a tracer is what is compared first"},
    false};
inline const Knob<int> kHashCapacity{
    {.key = "hash.capacity",
     .unit = "log2 of cells",
     .help = "Room of the table: 10 is 1024 cells, 20 about a million, 12 bytes each.",
     .source = kHashArticle},
    20,
    10,
    24};
inline const Knob<int> kHashSearch{
    {.key = "hash.search",
     .unit = "slots",
     .help = "How many slots are looked at for a key before it is left without a cell.",
     .source = kHashArticle},
    10,
    1,
    64};
inline const Knob<HashProbing> kHashProbing{
    {.key = "hash.probing",
     .unit = "",
     .help = "Which slots are looked at: one after the other, each by a new hash, or those of one "
             "line of memory before another line.",
     .source = kHashArticle},
    HashProbing::linear,
    {"linear", "rehash", "bucket"}};
inline const Knob<double> kHashFootprint{{.key = "hash.footprint",
                                          .unit = "pixels",
                                          .help = "Wanted size of a cell in the picture.",
                                          .source = kHashArticle},
                                         5.0,
                                         0.1,
                                         1000.0};
inline const Knob<double> kHashSmallest{
    {.key = "hash.smallest_size",
     .unit = "m",
     .help = "Size of the smallest cells; others are larger by powers of two.",
     .source = kHashArticle},
    0.07,
    1e-4,
    1e4};
inline const Knob<double> kHashFixedSize{
    {.key = "hash.fixed_size",
     .unit = "m",
     .help = "One size for all cells, whatever their distance; 0: sizes by hash.footprint.",
     .source = "off: a fixed size is blocky nearby"},
    0.0,
    0.0,
    1e4};
inline const Knob<bool> kHashBlend{
    {.key = "hash.blend_sizes",
     .unit = "",
     .help = "Keep each pixel in a cell of its size and in the next larger one and show a mixture "
             "of both, so that no seam is seen where sizes change, and a new cell begins with what "
             "is known around it.",
     .source = "without it sizes jump, and accumulation starts anew as the camera comes closer"},
    true};
inline const Knob<double> kHashNormalBins{{.key = "hash.normal_bins",
                                           .unit = "bins per unit of a component",
                                           .help = "How finely normals tell cells apart.",
                                           .source = kHashArticle},
                                          3.0,
                                          0.0,
                                          100.0};
inline const Knob<double> kHashJitter{
    {.key = "hash.jitter",
     .unit = "cells",
     .help = "How far a lookup is moved at random in the tangent plane, to either side; rays are "
             "not moved.",
     .source = "measured: less FLIP than 0.5 or 0.25, see docs/user/hash.md"},
    1.0,
    0.0,
    10.0};
inline const Knob<bool> kHashStop{
    {.key = "hash.stop_tracing",
     .unit = "",
     .help = "Trace no rays for cells that have hash.sample_cap samples.",
     .source = kHashArticle},
    true};
inline const Knob<int> kHashSampleCap{
    {.key = "hash.sample_cap",
     .unit = "rays",
     .help = "Samples at which a cell has enough, with hash.stop_tracing.",
     .source = kHashArticle},
    500,
    1,
    32768};
inline const Knob<bool> kHashEvict{
    {.key = "hash.evict",
     .unit = "",
     .help = "Free cells that were not used for hash.eviction_age frames.",
     .source = kHashArticle},
    true};
inline const Knob<int> kHashEvictionAge{
    {.key = "hash.eviction_age",
     .unit = "frames",
     .help = "How long a cell is kept without use, with hash.evict.",
     .source = kHashArticle},
    20,
    1,
    10000};
inline const Knob<HashView> kHashView{
    {.key = "view.hash",
     .unit = "",
     .help = "What frame.view=hash shows: a colour for each cell, its samples up to "
             "hash.sample_cap, the frames since its last use up to hash.eviction_age, or, in red, "
             "the pixels that found no room in the table.",
     .source = "where the cells are comes first"},
    HashView::cell,
    {"cell", "samples", "age", "failed"}};

/// Of cells of level 0, metres.
inline float smallest_cell_size(const Settings& settings) {
    const double fixed = settings.get(kHashFixedSize);
    return static_cast<float>(fixed > 0.0 ? fixed : settings.get(kHashSmallest));
}

/// Every knob of this folder.
inline std::vector<const KnobBase*> spatial_hash_knobs() {
    return {&kHashEnabled,  &kHashCapacity,  &kHashSearch, &kHashProbing,     &kHashFootprint,
            &kHashSmallest, &kHashFixedSize, &kHashBlend,  &kHashNormalBins,  &kHashJitter,
            &kHashStop,     &kHashSampleCap, &kHashEvict,  &kHashEvictionAge, &kHashView};
}

} // namespace romascope
