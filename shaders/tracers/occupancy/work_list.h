// SPDX-License-Identifier: MIT
// How large triangles are handed on, in pieces. Either of strips: a strip is a row of up to 32
// columns of cells, a piece is 32 strips, one for each invocation of a workgroup. Or of columns
// that the invocations of a workgroup take in turn.
#pragma once
#include "shaders/common/cross.h"
#ifdef __cplusplus
namespace romascope::gpu {
#endif

const uint kStripsPerPiece = 32u;
/// Where work groups share columns: triangles of a group, and its invocations.
const uint kGroupTriangles = 32u;
/// About as many columns to a piece then, but for what takes more pieces than there may be.
const uint kColumnsPerPiece = 128u;
/// An entry is a triangle and a piece of it: no triangle of a grid of up to 256 cells has more.
const uint kPieceBits = 6u;
const uint kMostPieces = 1u << kPieceBits;
/// No more workgroups than any driver takes in a row. Pieces that no longer fit are done by the
/// invocation that finds them.
const uint kWorkListLength = 65535u;

/// Triangles to a row of invocations: a dispatch may have no more than 65535 groups across.
const uint kTriangleRow = 1u << 20;

/// What is dispatched over the list, and what has been asked of it. Laid out for std430.
struct WorkListHead {
    uint groups_x;
    uint groups_y;
    uint groups_z;
    uint wanted;
};

#ifdef __cplusplus
static_assert(sizeof(WorkListHead) == 16);
} // namespace romascope::gpu
#endif
