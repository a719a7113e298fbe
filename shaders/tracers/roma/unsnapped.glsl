// SPDX-License-Identifier: MIT
// Rays that keep their own direction (Zeng et al. 2023, section 4.2, "snap or not"): from column to
// column of the map in which they cross the fewest. What is left of a ray after the last iteration
// is traced snapped, and counted.
//
// In:   roma_tracer.glsl
// Out:  roma_counts: rays traced and, of them, those that were not finished
// Host: ROMA_ITERATIONS

layout(std430, binding = 5) buffer RomaCounts {
    uint roma_rays;
    uint roma_unfinished;
};

int roma_map_towards(vec3 direction) {
    int best = 0;
    float fewest = roma_crossings_in(0, direction);
    for (int map = 1; map < TRACER_CANDIDATE_COUNT; ++map) {
        float crossings = roma_crossings_in(map, direction);
        best = crossings < fewest ? map : best;
        fewest = min(crossings, fewest);
    }
    return best;
}

/// Metres from the surface; negative for a miss.
float roma_unsnapped_hit(vec3 point, vec3 normal, vec3 direction, float t_max) {
    int map = roma_map_towards(direction);
    RomaWalk walk = roma_walk_in(map, point, normal, direction, t_max);
    float stop = min(walk.leaves, walk.ends);
    int count = roma_slice_count(map);
    int allowed = ROMA_ESCAPE;
    float entry = -1.0;
    bool hit = false, unfinished = false;
    for (int i = 0; i < ROMA_ITERATIONS; ++i) {
        if (walk.entered >= stop)
            break;
        float border = roma_walk_border(walk);
        bool snapped = i == ROMA_ITERATIONS - 1 && border < stop;
        RomaSpan way = roma_walk_span(walk, snapped ? walk.ends : min(border, stop), count);
        RomaSpan span = roma_bounded(map, way);
        int cell = -1;
        if (span.first <= span.last) {
            uint words[ROMA_WORDS];
            roma_load(map, span.column, words);
#if ROMA_ESCAPE
            int first = span.first, last = span.last;
            int passed = last - first + 1;
            int run = min(roma_run_in(words, span, walk.forward, allowed), passed);
            span = roma_escaped(span, run, walk.forward);
            // The run goes on in the next column only if it fills this one, and does not leave the
            // grid before.
            bool stays = walk.forward ? last == way.last : first == way.first;
            allowed = span.first > span.last && stays ? allowed - passed : 0;
#endif
            roma_cut(words, span, walk.forward, false);
            cell = roma_first_cell(words, walk.forward);
        } else {
            allowed = 0; // free, as it is beyond the grid
        }
        hit = cell >= 0;
        entry = roma_walk_entry(walk, cell);
        unfinished = snapped && !(hit && entry < border);
        if (hit || border >= stop)
            break;
        walk = roma_walk_on(walk);
    }
    atomicAdd(roma_rays, 1u);
    if (unfinished)
        atomicAdd(roma_unfinished, 1u);
    return hit ? roma_walk_distance(walk, entry) : -1.0;
}
