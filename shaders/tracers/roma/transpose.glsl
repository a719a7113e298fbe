// SPDX-License-Identifier: MIT
// Transposes a block of 32 x 32 bits in five butterfly steps (Warren, Hacker's Delight, 7-3): bit b
// of row r becomes bit r of row b. By a work group, one row to an invocation, or by one invocation.
//
// Host: TRANSPOSE_ROWS_APART 0 or 1; with 1, local_size_x must be 32 and TRANSPOSE_BLOCKS blocks lie
//       along y in a work group; TRANSPOSE_ROW uint, or uvec2 to uvec4 for as many blocks at once

/// Bits whose place has the bit `span` unset.
const uint kLowHalves[5] = uint[5](0x0000FFFFu, 0x00FF00FFu, 0x0F0F0F0Fu, 0x33333333u, 0x55555555u);

#if TRANSPOSE_ROWS_APART
shared TRANSPOSE_ROW transpose_rows[2][TRANSPOSE_BLOCKS][32];

/// All invocations of the work group come here. Gives row gl_LocalInvocationID.x of the result.
TRANSPOSE_ROW transposed(TRANSPOSE_ROW row) {
    uint lane = gl_LocalInvocationID.x, block = gl_LocalInvocationID.y;
    for (int level = 0; level < 5; ++level) {
        int span = 16 >> level;
        uint low = kLowHalves[level];
        // Two sets of rows in turn, so that one barrier a step is enough.
        transpose_rows[level & 1][block][lane] = row;
        barrier();
        TRANSPOSE_ROW other = transpose_rows[level & 1][block][lane ^ uint(span)];
        // The half that comes from the other row is turned into its place.
        bool first = (lane & uint(span)) == 0u;
        int turn = first ? span : 32 - span;
        uint keep = first ? low : ~low;
        row = (row & keep) | (((other << turn) | (other >> (32 - turn))) & ~keep);
    }
    return row;
}
#else
void transpose(inout uint rows[32]) {
    for (int level = 0; level < 5; ++level) {
        int span = 16 >> level;
        uint low = kLowHalves[level];
        for (int pair = 0; pair < 16; ++pair) {
            int first = ((pair & ~(span - 1)) << 1) | (pair & (span - 1));
            uint swapped = ((rows[first] >> span) ^ rows[first + span]) & low;
            rows[first] ^= swapped << span;
            rows[first + span] ^= swapped;
        }
    }
}
#endif
