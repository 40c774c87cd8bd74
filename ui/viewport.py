"""The one OpenGL widget behind all views: draws when Qt asks, and turns mouse and trackpad into a camera.

One pyvistaqt interactor with three renderers side by side serves one view as well as three: one GL context, one
upload of what the views share, one frame for all of them. For a single view the first renderer gets the whole
widget and the others are switched off, so changing over neither makes nor destroys anything.

VTK's own interaction is not used. A camera record (`camera.Camera`) is moved by Qt events and handed to VTK just
before a frame, and only ``paintGL`` renders: a drag costs one frame per step, not two, and no stray key of VTK's
or pyvista's interactor styles reaches the picture.
"""

from __future__ import annotations

import contextlib
from time import perf_counter
from typing import Any

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QKeyEvent, QMouseEvent, QNativeGestureEvent, QResizeEvent, QWheelEvent
from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor

from ui.camera import ZOOM_RANGE, Camera
from ui.views.panes import PANES, Panes

_TURN_PER_HEIGHT = np.pi * 0.9
_WHEEL_STEP, _PIXEL_STEP = 0.0012, 0.004
_STILL_AFTER_MS = 140
_CLICK_REACH = 4.0
_SOFTWARE = ("llvmpipe", "softpipe", "swrast", "software", "swiftshader", "basic render")


class Viewport(Panes, QtInteractor):  # type: ignore[misc]
    """One to three panes, with a common camera or one each.

    Signals
    -------
    camera_changed()
        By the mouse; the frame is already asked for.
    pointer_moved(object), pointer_left()
        QPointF, without a button held.
    clicked(object), double_clicked(object)
        QPointF.
    drawing(bool)
        A frame is about to be drawn, in a hurry because another will follow or not.
    """

    camera_changed = Signal()
    pointer_moved = Signal(object)
    pointer_left = Signal()
    clicked = Signal(object)
    double_clicked = Signal(object)
    drawing = Signal(bool)
    _resizing = False

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent, shape=(1, PANES), border=False, multi_samples=0, auto_update=False)
        self.setAcceptDrops(False)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.iren.interactor.SetInteractorStyle(None)
        self.frame_ms, self.frames = 0.0, 0
        self.software: bool | None = None
        self._grabbed: tuple[Qt.MouseButton, QPointF] | None = None
        self._pressed_at: QPointF | None = None
        self._moving = False
        self._still = QTimer(self, singleShot=True, interval=_STILL_AFTER_MS)
        self._still.timeout.connect(self._on_still)
        self.begin_panes(self.renderers)

    # ---- drawing -------------------------------------------------------------------------------------

    def render(self, *_: Any, **__: Any) -> None:
        """Ask Qt for a frame; nothing is drawn outside of `paintGL`."""
        self.update()

    def initializeGL(self) -> None:
        super().initializeGL()
        name = ""
        with contextlib.suppress(Exception):
            name = str(self.context().functions().glGetString(0x1F01))
        self.software = any(word in name.lower() for word in _SOFTWARE)
        self.ren_win.SetMultiSamples(0 if self.software else 4)

    def paintGL(self) -> None:
        if self._resizing:
            return
        start = perf_counter()
        self._prepare()
        super().paintGL()
        self.frame_ms, self.frames = 1000 * (perf_counter() - start), self.frames + 1

    def _prepare(self) -> None:
        self.hand_over_cameras()
        hurried = bool(self.software) and self._moving
        self.drawing.emit(hurried)
        self.set_finish(smoothed=bool(self.software) and not hurried, peeled=not hurried)

    def set_moving(self) -> None:
        """The picture is about to change again and again: without a GPU, leave out the finish until it stands still."""
        self._moving = True
        self._still.start()

    def _on_still(self) -> None:
        self._moving = False
        if self.software:
            self.update()

    # ---- mouse, wheel, trackpad ----------------------------------------------------------------------

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._grabbed is None:
            self._grabbed = (event.button(), event.position())
            self.active = self.pane_at(event.position())[0]
            self._pressed_at = event.position() if event.button() == Qt.MouseButton.LeftButton else None
        self.pointer_left.emit()
        event.accept()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._grabbed is not None and event.button() == self._grabbed[0]:
            self._grabbed = None
            if self._moving:
                self._still.start(0)
            if self._pressed_at is not None:
                self.clicked.emit(event.position())
        event.accept()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self.double_clicked.emit(event.position())
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        event.accept()
        if self._grabbed is None:
            self.pointer_moved.emit(event.position())
            return
        button, before = self._grabbed
        self._grabbed = (button, event.position())
        if self._pressed_at is not None and (event.position() - self._pressed_at).manhattanLength() > _CLICK_REACH:
            self._pressed_at = None
        half = max(self.height(), 1) / 2
        dx, dy = (event.position().x() - before.x()) / half, (before.y() - event.position().y()) / half
        modifiers = event.modifiers()
        if button == Qt.MouseButton.MiddleButton or modifiers & Qt.KeyboardModifier.ShiftModifier:
            self._move(self.look.panned(dx, dy))
        elif button == Qt.MouseButton.RightButton:
            self._zoom(float(np.exp(1.6 * dy)), 0.0, 0.0)
        elif modifiers & Qt.KeyboardModifier.ControlModifier:
            self._move(self.look.rolled(dx * _TURN_PER_HEIGHT / 2))
        else:
            self._move(self.look.turned(dx * _TURN_PER_HEIGHT / 2, dy * _TURN_PER_HEIGHT / 2))

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.accept()
        fine = event.pixelDelta().y()
        step = _PIXEL_STEP * fine if fine else _WHEEL_STEP * event.angleDelta().y()
        self.active, x, y = self.pane_at(event.position())
        self._zoom(float(np.exp(np.clip(step, -1.0, 1.0))), x, y)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QNativeGestureEvent) and event.gestureType() == Qt.NativeGestureType.ZoomNativeGesture:
            self.active, x, y = self.pane_at(event.position())
            self._zoom(float(np.exp(np.clip(event.value(), -1.0, 1.0))), x, y)
            return True
        return bool(super().event(event))

    def _zoom(self, factor: float, x: float, y: float) -> None:
        low, high = (limit * self.bounds_radius for limit in ZOOM_RANGE)
        target = min(max(self.look.half_height / factor, low), high)
        self._move(self.look.zoomed(self.look.half_height / target, x, y))

    def _move(self, camera: Camera) -> None:
        self.set_moving()
        self.set_camera(camera, self.active)
        self.camera_changed.emit()

    # ---- nothing of this reaches VTK -------------------------------------------------------------------

    def enterEvent(self, event: QEvent) -> None:
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        self.pointer_left.emit()
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        event.ignore()

    def closeEvent(self, event: QCloseEvent) -> None:
        self._still.stop()
        super().closeEvent(event)
        self._forget_context()  # its wrappers would outlive what they stand for

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Qt paints here at once, also at sizes that are never seen while panels come and go; leave it for later."""
        self._resizing = True
        try:
            super().resizeEvent(event)
        finally:
            self._resizing = False
        self.update()
        self.camera_changed.emit()
