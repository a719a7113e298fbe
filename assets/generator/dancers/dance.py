# SPDX-License-Identifier: MIT
"""What the jointed figures dance. A loop of 3.2 s."""

from .figure import jerky_loop, pose, smooth_loop

PERIOD = 3.2
STEPS = 32  # keys of the dancer, every 0.1 s


def dancer():
    """Sways, kicks, drops, turns once on one leg, lands, bends."""
    wide = {"upper arm": (0, -12, 42), "lower arm": (0, -18, 6), "hand": (0, 0, 8)}
    high = {"upper arm": (0, -15, 112), "lower arm": (0, -28, 22), "hand": (0, 0, 15)}
    low = {"upper arm": (0, -30, -12), "lower arm": (0, -40, 0), "hand": (0, -10, -10)}
    ring = {"upper arm": (0, -52, 26), "lower arm": (0, -58, 0), "hand": (0, -12, 0)}
    stand = {"thigh": (0, 10, 5), "shin": (4, 0, 0), "foot": (-4, 0, 0)}
    bent = {"thigh": (-52, 24, 14), "shin": (84, 0, 0), "foot": (-32, 0, 0)}
    toes = {"thigh": (2, 10, 2), "shin": (2, 0, 0), "foot": (48, 0, 0)}
    passe = {"thigh": (-74, 42, 16), "shin": (112, 0, 0), "foot": (42, 0, 0)}
    kick = {"thigh": (-86, 4, 6), "shin": (10, 0, 0), "foot": (40, 0, 0)}
    lunge = {"thigh": (-46, 20, 26), "shin": (58, 0, 0), "foot": (-14, 0, -4)}
    back = {"thigh": (16, 8, 20), "shin": (8, 0, 0), "foot": (8, 0, -4)}
    keys = [
        (0.0, pose({**wide, **stand}, {**wide, **stand}, hips=(0, -12, 0), chest=(-4, 0, 0),
            head=(-4, 12, 0))),
        (0.38, pose({**high, **stand}, {**low, "thigh": (-20, 14, 8), "shin": (44, 0, 0), "foot":
            (24, 0, 0)}, hips=(0, 18, -5), spine=(0, 6, -8), chest=(-6, 10, -8), head=(-6, 14, 6),
            shift=(0.08, 0, 0.02))),
        (0.74, pose({**wide, **toes}, {**high, **kick}, hips=(-8, 4, 0), spine=(-6, 0, 0),
            chest=(-8, -8, 0), head=(-6, 0, 0), shift=(0.10, 0, 0.06), jump=(0.02,))),
        (1.06, pose({**low, **bent}, {**low, **bent}, hips=(14, -14, 0), spine=(10, -6, 0),
            chest=(8, -12, 0), head=(-10, 0, 0), shift=(0.05, 0, 0.04))),
        (1.38, pose({**ring, **toes}, {**ring, **passe}, hips=(0, 50, 0), chest=(-4, 16, 0),
            head=(0, -20, 0), shift=(0.0, 0, 0.0), jump=(0.03,))),
        (1.70, pose({**high, **toes}, {**high, **passe}, hips=(0, 178, 0), chest=(-8, 4, 0),
            head=(-6, 10, 0), shift=(-0.04, 0, -0.02))),
        (2.02, pose({**high, **toes}, {**ring, **passe}, hips=(0, 300, 0), chest=(-4, -8, 0),
            head=(0, 20, 0), shift=(-0.06, 0, 0.0))),
        (2.36, pose({**wide, **lunge}, {**wide, **back}, hips=(6, 352, -6), chest=(0, 16, -4),
            head=(-6, 16, 0), shift=(0.12, 0, 0.05))),
        (2.76, pose({**low, **lunge}, {**high, **back}, hips=(4, 344, 4), spine=(0, 0, 12),
            chest=(2, 0, 16), head=(0, -6, 12), shift=(0.08, 0, 0.03))),
    ]
    # At the loop's end the turn has been a whole one; back there, the angle is the first key's.
    return smooth_loop(keys, PERIOD, STEPS)


def puppet():
    """Snaps from pose to pose within 0.14 s."""
    hang = {"upper": (0, 0, 10), "fore": (-12, 0, 0)}
    side = {"upper": (0, 0, 88), "fore": (0, 0, 4)}
    up = {"upper": (0, 0, 92), "fore": (0, 0, 82)}
    down = {"upper": (0, 0, 88), "fore": (0, 0, -84)}
    ahead = {"upper": (-84, 0, 6), "fore": (-8, 0, 0), "palm": (-60, 0, 0)}
    straight = {"femur": (0, 0, 3)}
    knee = {"femur": (-76, 0, 6), "calf": (82, 0, 0), "sole": (16, 0, 0)}
    squat = {"femur": (-46, 0, 20), "calf": (70, 0, 0), "sole": (-24, 0, -18)}
    keys = [
        (0.0, pose({**hang, **straight}, {**hang, **straight}, skull=(4, 0, 0))),
        (0.4, pose({**up, **knee}, {**down, **straight}, ribs=(0, 16, 0), skull=(0, 30, 0))),
        (0.8, pose({**down, **straight}, {**up, **knee}, ribs=(0, -16, 0), skull=(0, -30, 0))),
        (1.2, pose({**up, **squat}, {**up, **squat}, pelvis=(0, 0, 0), ribs=(8, 0, 0), skull=(-10,
            0, 0))),
        (1.6, pose({**side, **straight}, {**side, **straight}, pelvis=(0, 90, 0), waist=(0, 0, 14),
            skull=(0, -70, 0))),
        (2.0, pose({**ahead, **straight}, {**side, **knee}, pelvis=(0, 90, 0), ribs=(0, -40, 0),
            skull=(0, -40, 8))),
        (2.4, pose({**down, **squat}, {**up, **squat}, pelvis=(0, 0, 0), waist=(0, 0, -12), ribs=(0,
            0, -10), skull=(0, 0, 18))),
        (2.8, pose({**ahead, **straight}, {**ahead, **straight}, waist=(24, 0, 0), ribs=(14, 0, 0),
            skull=(20, 0, 0))),
    ]
    return jerky_loop(keys, PERIOD, 0.14)
