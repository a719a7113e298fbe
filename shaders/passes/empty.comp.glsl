// SPDX-License-Identifier: MIT
// Does nothing, in one work group: what a dispatch costs by itself.

layout(local_size_x = 32) in;

void main() {}
