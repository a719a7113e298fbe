// SPDX-License-Identifier: MIT
// Tables the places of columns that rays look up: it depends on the directions alone.
//
// In:  shear_shared.h
// Out: shear_places: of each map those along p, then those along q; see shear_packed
// Host: ROMA_TEXELS_PER_COLUMN

layout(std140, binding = 5) uniform ShearShared { ShearGrid shear_grid; };
layout(std430, binding = 1) readonly buffer ShearMaps { ShearMap shear_maps[]; };
layout(std430, binding = 2) writeonly buffer ShearPlaces { uvec2 shear_places[]; };

/// One invocation of `count` that share it.
void table_places(int invocation, int count) {
    int places = shear_grid.row_words.w;
    int entries = 2 * shear_grid.first_word.w * places;
    for (int i = invocation; i < entries; i += count) {
        ShearMap map = shear_maps[i / (2 * places)];
        ivec3 size = shear_size(shear_grid, map.slope.z);
        int place = shear_place_of_entry(i % places, size.z);
        bool along_p = (i / places) % 2 == 0;
        ShearPlace found = along_p ? shear_place_along_p(shear_grid, map, place)
                                   : shear_place_along_q(shear_grid, map, place);
        int texels = (along_p ? 1 : size.x) * ROMA_TEXELS_PER_COLUMN;
        shear_places[i] = shear_packed(found, texels, along_p ? map.slope.w : 0);
    }
}
