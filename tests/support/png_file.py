# SPDX-License-Identifier: MIT
"""Reads the PNG files that the program writes; for tests, which use nothing but Python itself."""

import struct
import zlib
from pathlib import Path


def read_png(path):
    """(width, height, channels, rows of tuples) of an 8-bit PNG without interlacing."""
    data = Path(path).read_bytes()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        assert struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0] == zlib.crc32(
            kind + body), f"{path}: damaged"
        if kind == b"IHDR":
            width, height, depth, color, _, _, interlaced = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    assert depth == 8 and not interlaced and color in (0, 2), path
    channels = 1 if color == 0 else 3
    raw, stride = zlib.decompress(packed), width * channels
    rows, above = [], bytes(stride)
    for y in range(height):
        kind, *line = raw[y * (stride + 1):(y + 1) * (stride + 1)]
        for x in range(stride):
            left = line[x - channels] if x >= channels else 0
            corner = above[x - channels] if x >= channels else 0
            estimate = left + above[x] - corner
            paeth = min((left, above[x], corner), key=lambda value: abs(estimate - value))
            guess = (0, left, above[x], (left + above[x]) // 2, paeth)[kind]
            line[x] = (line[x] + guess) & 255
        rows.append([tuple(line[x:x + channels]) for x in range(0, stride, channels)])
        above = line
    return width, height, channels, rows
