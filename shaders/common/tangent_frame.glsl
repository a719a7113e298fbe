// SPDX-License-Identifier: MIT

/// Two unit vectors at right angles to the unit vector `normal` and to each other (Duff et al. 2017,
/// Building an Orthonormal Basis, Revisited).
mat2x3 tangent_frame(vec3 normal) {
    float side = normal.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (side + normal.z);
    float b = normal.x * normal.y * a;
    return mat2x3(vec3(1.0 + side * normal.x * normal.x * a, side * b, -side * normal.x),
                  vec3(b, side + normal.y * normal.y * a, -normal.y));
}
