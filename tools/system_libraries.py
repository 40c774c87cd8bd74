"""Prints the Debian packages that this machine lacks for the window; nothing when all is there.

Runs on any Python 3, with the standard library alone. With ``--screen`` the virtual screen counts too.
"""

from __future__ import annotations

import ctypes
import shutil
import sys

LIBRARIES = {
    "libdbus-1.so.3": "libdbus-1-3",
    "libEGL.so.1": "libegl1",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libGL.so.1": "libgl1",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libgomp.so.1": "libgomp1",
    "libX11.so.6": "libx11-6",
    "libX11-xcb.so.1": "libx11-xcb1",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-sync.so.1": "libxcb-sync1",
    "libxcb-xfixes.so.0": "libxcb-xfixes0",
    "libxcb-xinerama.so.0": "libxcb-xinerama0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxkbcommon.so.0": "libxkbcommon0",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
    "libXrender.so.1": "libxrender1",
}
SCREEN_PROGRAMS = {"xvfb-run": "xvfb", "Xvfb": "xvfb", "xauth": "xauth"}


def loads(name: str) -> bool:
    """Whether the dynamic linker finds the library."""
    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True


def missing_packages(with_screen: bool) -> list[str]:
    """Names of the missing Debian packages, sorted, each once."""
    packages = {package for library, package in LIBRARIES.items() if not loads(library)}
    if with_screen:
        packages |= {package for program, package in SCREEN_PROGRAMS.items() if shutil.which(program) is None}
    return sorted(packages)


if __name__ == "__main__":
    print(" ".join(missing_packages("--screen" in sys.argv[1:])))
