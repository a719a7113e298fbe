// SPDX-License-Identifier: MIT
// Mean of all frames so far: mean += (value - mean) / count, which keeps its precision however many
// frames there are, and is exact where every frame gives the same.
//
// In:   value, one channel or four
// Out:  mean, MEAN_FORMAT, as many channels in 32-bit floats, read and written
// Host: count: frames including this one, 1 starts anew; picture_size
layout(local_size_x = 16, local_size_y = 16) in;
layout(binding = 0) uniform sampler2D value;
layout(MEAN_FORMAT, binding = 0) uniform image2D mean;
uniform uint count;
uniform ivec2 picture_size;

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, picture_size)))
        return;
    vec4 current = texelFetch(value, pixel, 0);
    vec4 old = count > 1u ? imageLoad(mean, pixel) : current;
    imageStore(mean, pixel, old + (current - old) / float(count));
}
