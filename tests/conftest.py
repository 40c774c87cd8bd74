"""For all tests: hypothesis draws the same examples in every run; ``HYPOTHESIS_PROFILE=explore`` looks further."""

from __future__ import annotations

import atexit
import faulthandler
import os
import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest
from hypothesis import settings

LAST_WORDS = "GEARSTUDIO_LAST_WORDS"
RUNNERS = ("/pluggy/", "/_pytest/", "/xdist/", "/execnet/", "<string>")

settings.register_profile("steady", derandomize=True, deadline=None)
settings.register_profile("explore", deadline=None)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "steady"))


@pytest.hookimpl(trylast=True)
def pytest_configure() -> None:
    """Every process of a parallel run has a screen of its own, and a file for where it was when it crashed."""
    worker = os.environ.get("PYTEST_XDIST_WORKER")
    if not worker:
        os.environ[LAST_WORDS] = tempfile.mkdtemp()
        return
    faulthandler.enable((Path(os.environ[LAST_WORDS]) / f"{worker}-{os.getpid()}").open("w"))
    if shutil.which("Xvfb"):
        told, tell = os.pipe()
        words = ["Xvfb", "-displayfd", str(tell), "-screen", "0", "1600x1000x24", "-nolisten", "tcp"]
        screen = subprocess.Popen(words, pass_fds=(tell,), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        atexit.register(screen.kill)
        os.environ["DISPLAY"] = f":{os.read(told, 16).decode().strip()}"  # windows would take each other's focus


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Where the processes were that crashed, at the end, where it is seen."""
    if os.environ.get("PYTEST_XDIST_WORKER"):
        return
    for path in sorted(Path(os.environ[LAST_WORDS]).iterdir()):
        lines = path.read_text(errors="replace").splitlines()
        if lines:
            terminalreporter.section(f"crash of {path.name}")
            terminalreporter.write_line("\n".join(line for line in lines if not any(part in line for part in RUNNERS)))
    shutil.rmtree(os.environ[LAST_WORDS], ignore_errors=True)
