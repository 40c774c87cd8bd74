"""What tests of the real window need."""

from __future__ import annotations

import os
import sys

import pytest

NEEDS_SCREEN = [
    pytest.mark.ui,
    pytest.mark.gl,
    pytest.mark.skipif(
        os.environ.get("QT_QPA_PLATFORM") == "offscreen"
        or (sys.platform.startswith("linux") and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))),
        reason="needs a screen with OpenGL",
    ),
]
