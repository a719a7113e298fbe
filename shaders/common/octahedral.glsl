// SPDX-License-Identifier: MIT
// Unit vectors in 32 bits (Cigolle et al. 2014, A Survey of Efficient Representations for
// Independent Unit Vectors: oct32). Error below 4e-5 rad.

vec2 fold_lower_half(vec2 e) {
    return (1.0 - abs(e.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(e, vec2(0.0)));
}

uint encode_direction(vec3 n) {
    vec2 e = n.xy / (abs(n.x) + abs(n.y) + abs(n.z));
    return packSnorm2x16(n.z < 0.0 ? fold_lower_half(e) : e);
}

vec3 decode_direction(uint bits) {
    vec2 e = unpackSnorm2x16(bits);
    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));
    if (n.z < 0.0)
        n.xy = fold_lower_half(n.xy);
    return normalize(n);
}
