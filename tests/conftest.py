"""For all tests: hypothesis draws the same examples in every run; ``HYPOTHESIS_PROFILE=explore`` looks further."""

from __future__ import annotations

import atexit
import os
import shutil
import subprocess

from hypothesis import settings

settings.register_profile("steady", derandomize=True, deadline=None)
settings.register_profile("explore", deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "steady"))


def pytest_configure() -> None:
    """Every process of a parallel run has a screen of its own: windows would take each other's focus."""
    if os.environ.get("PYTEST_XDIST_WORKER") and shutil.which("Xvfb"):
        told, tell = os.pipe()
        words = ["Xvfb", "-displayfd", str(tell), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"]
        screen = subprocess.Popen(words, pass_fds=(tell,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        atexit.register(screen.kill)
        os.environ["DISPLAY"] = f":{os.read(told, 16).decode().strip()}"
