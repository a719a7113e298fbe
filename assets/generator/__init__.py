# SPDX-License-Identifier: MIT
"""Makes the scenes in `assets/`: shapes, a glTF writer, and one module per scene."""
