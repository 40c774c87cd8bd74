"""Draws the panes without a screen: a render window of its own, for pictures of any size and for the command line."""

from __future__ import annotations

import os
import sys
from time import perf_counter

import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (makes the render window)
from PySide6.QtCore import QSize, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkObject, vtkUnsignedCharArray
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from ui.views.panes import PANES, WHOLE, Panes, Tile


class StillViewport(Panes, QWidget):  # type: ignore[misc]
    """The same panes as a `viewport.Viewport`, drawn when they are asked for and only into pictures.

    Signals
    -------
    As those of `viewport.Viewport`; nobody points at a picture.
    """

    camera_changed = Signal()
    pointer_moved = Signal(object)
    pointer_left = Signal()
    clicked = Signal(object)
    double_clicked = Signal(object)
    drawing = Signal(bool)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        _keep_quiet_about_missing_screens()
        self.ren_win = vtkRenderWindow()
        self.ren_win.SetOffScreenRendering(True)
        self.ren_win.SetMultiSamples(0)
        self.ren_win.SetAlphaBitPlanes(True)
        self.renderers = tuple(vtkRenderer() for _ in range(PANES))
        for renderer in self.renderers:
            self.ren_win.AddRenderer(renderer)
        self.software, self.frame_ms = True, 0.0
        self.begin_panes(self.renderers)

    def set_moving(self) -> None:
        """A picture is always finished."""

    def set_ground(self, top: str, bottom: str) -> None:
        """Pictures are taken without a ground; who wants one paints it below."""

    def picture(self, size: QSize, tile: Tile = WHOLE) -> QImage:
        """A frame in pixels of its own, or a piece of a larger one, clear where nothing is.

        Raises
        ------
        RuntimeError
            OpenGL does not draw here.
        """
        start = perf_counter()
        width, height = size.width(), size.height()
        self.ren_win.SetSize(width, height)
        for renderer in self.renderers:
            renderer.SetBackground(0.0, 0.0, 0.0)
            renderer.SetBackgroundAlpha(0.0)
            renderer.SetGradientBackground(False)
        self.hand_over_cameras(tile)
        self.drawing.emit(False)
        self.set_finish(smoothed=False, peeled=True)
        self.ren_win.Render()
        pixels = vtkUnsignedCharArray()
        self.ren_win.GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels)
        if pixels.GetNumberOfTuples() != width * height:
            raise RuntimeError("OpenGL does not draw here")
        flipped = np.ascontiguousarray(vtk_to_numpy(pixels).reshape(height, width, 4)[::-1])
        image = QImage(flipped.data, width, height, 4 * width, QImage.Format.Format_RGBA8888_Premultiplied).copy()
        self.frame_ms = 1000 * (perf_counter() - start)
        return image

    def close(self) -> bool:
        """Give back what the render window holds."""
        self.ren_win.Finalize()
        for renderer in self.renderers:
            self.ren_win.RemoveRenderer(renderer)
        return bool(super().close())


def _keep_quiet_about_missing_screens() -> None:
    if sys.platform.startswith("linux") and not os.environ.get("DISPLAY"):
        vtkObject.GlobalWarningDisplayOff()
