# SPDX-License-Identifier: MIT
"""Pictures of leaves with alpha, painted here, as PNG files inside the scene.

The PNG's data are stored, not compressed: the bytes do not depend on a version of zlib. A palette
keeps them small. https://www.w3.org/TR/png-3/
"""

import struct
import zlib

SHADES, LEVELS = 32, 8  # of colour and of alpha; a pixel is one byte, shade * LEVELS + level
LINEAR, MIPMAPS, CLAMP = 9729, 9987, 33071


class Painting:
    """A square of pixels; (0, 0) is the upper left corner, 1 its side."""

    def __init__(self, size):
        self.size = size
        self.alpha = [0.0] * (size * size)
        self.shade = [0.5] * (size * size)

    def paint(self, low, high, function):
        """Within a box, over what is there: `function(x, y)` gives (distance, shade): to the
        outline, negative inside, as a share of the picture's side; shade in [0, 1]."""
        n = self.size
        for j in range(max(0, int(low[1] * n) - 1), min(n, int(high[1] * n) + 2)):
            for i in range(max(0, int(low[0] * n) - 1), min(n, int(high[0] * n) + 2)):
                distance, shade = function((i + 0.5) / n, (j + 0.5) / n)
                cover = min(1.0, max(0.0, 0.5 - distance * n))
                at = j * n + i
                if cover > 0.0 and cover >= 0.5 * self.alpha[at]:
                    self.shade[at] = shade
                self.alpha[at] = max(self.alpha[at], cover)

    def spread(self):
        """Gives empty pixels the shades of their neighbours, lest a rim shows through filters."""
        n = self.size
        known = [a > 0.0 for a in self.alpha]
        for _ in range(4):
            found = {}
            for j in range(n):
                for i in range(n):
                    if known[j * n + i]:
                        continue
                    total, count = 0.0, 0
                    for x, y in ((i - 1, j), (i + 1, j), (i, j - 1), (i, j + 1)):
                        if 0 <= x < n and 0 <= y < n and known[y * n + x]:
                            total += self.shade[y * n + x]
                            count += 1
                    if count:
                        found[j * n + i] = total / count
            for at, shade in found.items():
                self.shade[at], known[at] = shade, True

    def to_png(self, ramp):
        """`ramp`: colours (r, g, b) in 8 bits, sRGB, from shade 0 to 1, interpolated."""
        palette, transparency = bytearray(), bytearray()
        for k in range(SHADES):
            at = k / (SHADES - 1) * (len(ramp) - 1)
            i = min(int(at), len(ramp) - 2)
            color = [int(a + (b - a) * (at - i) + 0.5) for a, b in zip(ramp[i], ramp[i + 1])]
            for level in range(LEVELS):
                palette += bytes(color)
                transparency.append(255 * level // (LEVELS - 1))
        n, rows = self.size, bytearray()
        for j in range(n):
            rows.append(0)  # no filter
            for i in range(n):
                shade = min(1.0, max(0.0, self.shade[j * n + i]))
                level = int(self.alpha[j * n + i] * (LEVELS - 1) + 0.5)
                rows.append(int(shade * (SHADES - 1) + 0.5) * LEVELS + level)
        header = struct.pack(">IIBBBBB", n, n, 8, 3, 0, 0, 0)
        return (b"\x89PNG\r\n\x1a\n" + _chunk(b"IHDR", header) + _chunk(b"PLTE", palette)
            + _chunk(b"tRNS", transparency) + _chunk(b"IDAT", _stored(bytes(rows)))
            + _chunk(b"IEND", b""))


def add_texture(doc, name, png):
    """A PNG file's bytes as a texture; its edges do not repeat."""
    image = doc.append("images", {"name": name, "mimeType": "image/png", "bufferView":
        doc.add_view(png)})
    if "samplers" not in doc.root:
        doc.append("samplers", {"magFilter": LINEAR, "minFilter": MIPMAPS, "wrapS": CLAMP,
            "wrapT": CLAMP})
    return doc.append("textures", {"sampler": 0, "source": image})


def _chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + bytes(data) + struct.pack(">I", zlib.crc32(kind
        + bytes(data)))


def _stored(data):
    """A zlib stream of blocks that are not compressed (RFC 1950, RFC 1951)."""
    result, most = b"\x78\x01", 65535
    for i in range(0, len(data), most):
        block = data[i : i + most]
        last = i + most >= len(data)
        result += struct.pack("<BHH", last, len(block), 0xFFFF ^ len(block)) + block
    return result + struct.pack(">I", zlib.adler32(data))
