"""The command ``screenshot``, in a process of its own and without any screen."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtGui import QImage

ROOT = Path(__file__).parents[2]
pytestmark = pytest.mark.gl


def take(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    hidden = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    surroundings = {name: value for name, value in os.environ.items() if name not in hidden}
    command = [sys.executable, str(ROOT / "main.py"), "screenshot", "preset:default", *words]
    return subprocess.run(command, cwd=folder, env=surroundings, capture_output=True, text=True, timeout=180)


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="only there a screen can be taken away")
def test_leaves_a_picture_with_colours_and_scale(tmp_path):
    done = take(tmp_path, "--out", "p.png", "--method", "profile_sweep", "--variant", "published", "--size", "500x300",
                "--view", "concave", "--scale", "2")  # fmt: skip
    assert (done.returncode, done.stdout.strip()) == (0, "p.png"), done.stderr
    image = QImage(str(tmp_path / "p.png")).convertToFormat(QImage.Format.Format_RGBA8888)
    assert (image.width(), image.height()) == (1000, 600)
    pixels = np.array(image.constBits()).reshape(600, 1000, 4)[..., :3].astype(int)
    spread = pixels.max(axis=2) - pixels.min(axis=2)
    assert (spread[:, :880] > 60).mean() > 0.01 and (spread[:, 880:] > 60).mean() > 0.05
    assert [path.name for path in tmp_path.iterdir()] == ["p.png"]


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--out", "p.gif"), ".png"),
        (("--out", "p.png", "--view", "nowhere"), "nowhere"),
        (("--out", "p.png", "--size", "5x5"), "5x5"),
        (("--out", "p.png", "--scale", "9"), "9"),
    ],
)
def test_refuses_what_makes_no_sense_in_one_line(tmp_path, words, said):
    done = take(tmp_path, *words)
    assert done.returncode == 2 and said in done.stderr and len(done.stderr.splitlines()) == 1
    assert not list(tmp_path.iterdir())
