# SPDX-License-Identifier: MIT
"""Jointed figures: their joints, poses, and how a dance becomes keys that stand on the floor.

A figure faces +z, its left is +x. All joints are unturned at rest, so that a pose is one turn
(x, y, z in degrees, see `motion.turned`) for each joint.
"""

from .. import motion
from .. import vector as v


class Figure:
    """`joints`: (name, parent's name or None, place at rest) with parents first. Names that end in
    `.l` have a mirror image `.r`, which is made here."""

    def __init__(self, joints, soles):
        """`soles`: (joint, point at rest) of what may touch the floor, of the left foot."""
        self.names, self.parent, self.place = [], {}, {}
        for name, parent, place in joints:
            self._joint(name, parent, place)
            if name.endswith(".l"):
                x, y, z = place
                self._joint(_right(name), _right(parent), (-x, y, z))
        self.soles = soles + [(_right(name), (-x, y, z)) for name, (x, y, z) in soles]

    def _joint(self, name, parent, place):
        self.names.append(name)
        self.parent[name] = parent
        self.place[name] = place

    def offset(self, name):
        """From the parent's place."""
        parent = self.parent[name]
        return self.place[name] if parent is None else v.sub(self.place[name], self.place[parent])

    def add_nodes(self, doc, parent, meshes=None):
        """The joints as nodes below `parent`: index by name. `meshes`: what hangs on some."""
        nodes = {}
        for name in self.names:
            above = self.parent[name]
            nodes[name] = doc.add_node(name, (meshes or {}).get(name), self.offset(name),
                parent=parent if above is None else nodes[above])
        return nodes

    def standing(self, pose, height=0.0):
        """Place of the root such that the lowest sole is `height` above the floor."""
        low = min(self._point(pose, joint, p)[1] for joint, p in self.soles)
        root = self.place[self.names[0]]
        shift = pose.get("shift", (0.0, 0.0, 0.0))
        return (root[0] + shift[0], root[1] + height - low, root[2] + shift[2])

    def _point(self, pose, joint, p):
        """Where a point at rest goes, the root's place unchanged."""
        p = v.sub(p, self.place[joint])
        while True:
            p = v.add(motion.rotated(motion.turned(*pose.get(joint, (0.0, 0.0, 0.0))), p),
                self.offset(joint))
            joint = self.parent[joint]
            if joint is None:
                return p

    def animate(self, clip, nodes, times, poses):
        """Keys from poses at all times; the last is the first one's."""
        root = self.names[0]
        clip.add(nodes[root], "translation", times, [self.standing(pose, pose.get("jump",
            (0.0,))[0]) for pose in poses])
        for name in self.names:
            if any(name in pose for pose in poses):
                keys = [motion.turned(*pose.get(name, (0.0, 0.0, 0.0))) for pose in poses]
                clip.add(nodes[name], "rotation", times, keys)


def _right(name):
    return name[:-2] + ".r" if name.endswith(".l") else name


def pose(left=None, right=None, **both):
    """Turns by joint. `left`, `right`: of limbs, given as for the left side; `both`: of the trunk,
    and `shift` (x, 0, z) and `jump` (height,) in metres."""
    result = {name: tuple(map(float, turn)) for name, turn in both.items()}
    for name, (x, y, z) in (left or {}).items():
        result[name + ".l"] = (float(x), float(y), float(z))
    for name, (x, y, z) in (right or {}).items():
        result[name + ".r"] = (float(x), float(-y), float(-z))
    return result


def smooth_loop(keys, period, count):
    """(times, poses): `count` steps of a smooth loop through `keys`, (time, pose) pairs.

    Cubic Hermite pieces with the slopes of the neighbours (Catmull-Rom on uneven times). Where a
    turn differs by 360 degrees from the last key to the first, it goes on."""
    names = sorted({name for _, p in keys for name in p})
    full = [(t, {n: p.get(n, (0.0,) * (1 if n == "jump" else 3)) for n in names}) for t, p in keys]
    times = [period * i / count for i in range(count + 1)]
    poses = []
    for time in times[:-1]:
        i = max(k for k, (t, _) in enumerate(full) if t <= time + 1e-9)
        poses.append({name: _hermite(full, i, name, time, period) for name in names})
    return times, poses + poses[:1]


def _hermite(keys, i, name, time, period):
    def key(k):
        turns, k = divmod(k, len(keys))
        t, p = keys[k]
        whole = [360.0 * round((a - b) / 360.0) for a, b in zip(keys[-1][1][name],
            keys[0][1][name])] if name not in ("shift", "jump") else [0.0] * len(p[name])
        return t + period * turns, [x + turns * w for x, w in zip(p[name], whole)]

    (t0, p0), (t1, p1), (t2, p2), (t3, p3) = (key(i + k) for k in (-1, 0, 1, 2))
    u, h = (time - t1) / (t2 - t1), t2 - t1
    values = []
    for a, b, c, d in zip(p0, p1, p2, p3):
        m1, m2 = (c - a) / (t2 - t0) * h, (d - b) / (t3 - t1) * h
        values.append((2 * u**3 - 3 * u**2 + 1) * b + (u**3 - 2 * u**2 + u) * m1
            + (3 * u**2 - 2 * u**3) * c + (u**3 - u**2) * m2)
    return tuple(values)


def jerky_loop(keys, period, snap):
    """(times, poses): holds each pose and goes to the next within the last `snap` seconds."""
    times, poses = [], []
    for (t, p), (following, _) in zip(keys, keys[1:] + [(period, None)]):
        times += [t, following - snap]
        poses += [p, p]
    return times + [period], poses + poses[:1]
