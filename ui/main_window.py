"""The window: puts the panels together, and knows nothing of what they mean."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QByteArray, QSettings, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QGuiApplication, QIcon, QPaintEvent
from PySide6.QtWidgets import QDockWidget, QMainWindow, QSizePolicy, QTabBar, QToolBar, QWidget

from ui.actions import Actions
from ui.analysis.area import COMPARISON, AnalysisArea
from ui.comparison_table import ComparisonTable
from ui.derived_panel import DerivedPanel
from ui.keyboard import lay_way
from ui.layer_panel import LayerPanel
from ui.messages import MessageBar
from ui.method_bar import MethodBar
from ui.parameter_form import ParameterForm
from ui.projects.drops import dropped_files
from ui.session import Session
from ui.sharing import Sharing
from ui.solid_panel import SolidPanel
from ui.status import Status
from ui.theme import HERE, refresh_icons
from ui.view_area import ViewArea
from ui.wheel_guard import guard_wheel
from ui.words import noted, tr

LAYOUT_VERSION = 4
LEAST = QSize(1280, 720)
ROOMY_WIDTH = 1500
"""From this width on the list of layers is open from the start."""
FORM_WIDTH, LAYERS_WIDTH, SOLID_WIDTH = 356, 252, 292
ANALYSIS_SHARE, ANALYSIS_LEAST = 0.46, 330
"""Height of the analysis below the views while one of its charts is in sight."""
LEFT = Qt.DockWidgetArea.LeftDockWidgetArea
RIGHT = Qt.DockWidgetArea.RightDockWidgetArea
BOTTOM = Qt.DockWidgetArea.BottomDockWidgetArea


class MainWindow(QMainWindow):
    """Form and derived values on the left, views in the middle, layers on the right, analysis below.

    ``may_close`` is asked before the window closes.

    Signals
    -------
    first_painted()
        The window is on the screen; heavy work may begin.
    design_dropped(object)
        Path of a design file that was dropped on the window, the first if there are several.
    others_dropped(object)
        Paths of the other files of that drop, points and further designs, as a tuple.
    closing()
        The window is about to close for good.
    """

    first_painted = Signal()
    design_dropped = Signal(object)
    others_dropped = Signal(object)
    closing = Signal()

    def __init__(self, session: Session, settings: QSettings | None = None) -> None:
        super().__init__()
        self.may_close: Callable[[], bool] = lambda: True
        self._settings = settings
        self._painted = self._closed = self._solid_mode = False
        self._layers_shown = True
        self._layers_aside, self._sizes = False, (FORM_WIDTH, LAYERS_WIDTH, ANALYSIS_LEAST)
        self.setObjectName("main_window")
        self.setWindowIcon(QIcon(str(HERE / "icons" / "gearstudio.svg")))
        self.setAcceptDrops(True)
        self.setDockOptions(QMainWindow.DockOption.AnimatedDocks | QMainWindow.DockOption.AllowNestedDocks)
        self.commands = Actions(self)
        self.form = ParameterForm()
        self.derived = DerivedPanel()
        self.area = ViewArea()
        self.sharing = Sharing(self.area, self)
        self.layer_panel = LayerPanel()
        self.solid_panel = SolidPanel()
        self.table = ComparisonTable(session)
        self.analysis = AnalysisArea(self.table)
        self.method_bar = MethodBar()
        self.status = Status()
        self.setStatusBar(self.status)
        self.setCentralWidget(self.area)
        self._make_toolbar()
        self._make_docks()
        self.setMinimumSize(LEAST.boundedTo(QGuiApplication.primaryScreen().availableSize()))
        guard_wheel()

    @property
    def settings(self) -> QSettings | None:
        """Where choices are remembered; None where nothing is to be."""
        return self._settings

    @property
    def messages(self) -> MessageBar:
        """The message bar over the views."""
        return self.area.messages

    def show_document(self, title: str, unsaved: bool) -> None:
        """Name of the design in the title bar, with the system's mark while it is unsaved."""
        self.setWindowTitle(tr("{title}[*] – GearStudio", title=title))
        self.setWindowModified(unsaved)

    def refresh_theme(self) -> None:
        """Draw icons anew after the colours have changed."""
        self.commands.refresh_icons()
        self.messages.refresh_icons()
        refresh_icons(self)
        self.table.refresh()
        self.analysis.refresh_theme()
        for widget in self.findChildren(QWidget):
            widget.update()

    def restore_layout(self) -> None:
        """Take the size and arrangement of the last time, or those of a new window; the style must be known."""
        available = QGuiApplication.primaryScreen().availableGeometry()
        self.resize(min(1480, available.width()), min(940, available.height() - 30))
        self.reset_layout()
        if self._settings is not None:
            geometry, layout = (self._settings.value(name) for name in ("geometry", "layout"))
            if isinstance(geometry, QByteArray) and isinstance(layout, QByteArray):
                self.restoreGeometry(geometry)
                self.restore_panels(layout)
        self.show_solid_mode(False)

    def layout_state(self) -> QByteArray:
        """Where the panels are, apart from what the solid mode moves."""
        self.show_solid_mode(False)
        return self.saveState(LAYOUT_VERSION)

    def restore_panels(self, layout: QByteArray) -> None:
        """Put the panels where `layout_state` found them."""
        before = self._dock_tabs()
        self.restoreState(layout, LAYOUT_VERSION)
        if len(self._dock_tabs()) > len(before):
            for tabs in before:
                tabs.hide()  # Qt has made new ones and left these in sight

    def _dock_tabs(self) -> list[QTabBar]:
        """Of panels that lie behind each other."""
        return self.findChildren(QTabBar, options=Qt.FindChildOption.FindDirectChildrenOnly)

    def show_solid_mode(self, solid: bool) -> None:
        """The panel of solids in the place of the layers, at full height, or the layers again."""
        layers = list(self._docks)[2]
        if solid == self._solid_mode:
            return
        self._solid_mode = solid
        if solid:
            self._layers_shown = not layers.isHidden()
        layers.setVisible(self._layers_shown and not solid)
        self.setCorner(Qt.Corner.BottomRightCorner, RIGHT if solid else BOTTOM)
        self._solid_dock.setVisible(solid)
        if solid:
            self.resizeDocks([self._solid_dock], [SOLID_WIDTH], Qt.Orientation.Horizontal)

    def reset_layout(self) -> None:
        """Put every panel back in its place."""
        solid = self._solid_mode
        self.analysis.expand.setChecked(False)
        self.show_solid_mode(False)
        for dock, area in self._docks.items():
            dock.setFloating(False)
            self.addDockWidget(area, dock)
            dock.show()
        parameters, derived, layers, _ = self._docks
        self.splitDockWidget(parameters, derived, Qt.Orientation.Vertical)
        layers.setVisible(self.width() >= ROOMY_WIDTH)
        self.resizeDocks([parameters, derived], [62, 38], Qt.Orientation.Vertical)
        self.resizeDocks([parameters, layers], [FORM_WIDTH, LAYERS_WIDTH], Qt.Orientation.Horizontal)
        for dock in self.findChildren(QDockWidget):
            if dock not in (*self._docks, self._solid_dock):
                self.add_low_dock(dock)
        self._fit_analysis()
        self._layers_shown = not layers.isHidden()
        self.show_solid_mode(solid)

    def add_low_dock(self, dock: QDockWidget) -> None:
        """Take a panel that is rarely wanted: behind the analysis, with a tab for each while it is open."""
        dock.setFloating(False)
        self.tabifyDockWidget(list(self._docks)[-1], dock)
        dock.hide()

    def _expand_analysis(self, on: bool) -> None:
        """Give the analysis the room of views and layers, or give it back; the other panels keep their widths."""
        parameters, _, layers, analysis = self._docks
        if on:
            self._sizes = parameters.width(), layers.width(), analysis.height()
            self._layers_aside = layers.isVisible()
        self.area.setVisible(not on)
        if self._layers_aside:
            layers.setVisible(not on)
        left, right, height = self._sizes
        self.resizeDocks([parameters, layers], [left, right], Qt.Orientation.Horizontal)
        if not on:
            self.resizeDocks([analysis], [height], Qt.Orientation.Vertical)

    def _fit_analysis(self) -> None:
        """Room for what is in sight below the views: the table as it is, a chart as large as it needs."""
        dock = list(self._docks)[-1]
        height = self.table.height() + self.analysis.bar.sizeHint().height()
        if self.analysis.tab != COMPARISON:
            height = max(ANALYSIS_LEAST, round(ANALYSIS_SHARE * self.height()), dock.height())
        self.resizeDocks([dock], [height], Qt.Orientation.Vertical)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if not self._painted:
            self._painted = True
            QTimer.singleShot(0, self, self.first_painted.emit)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if dropped_files(event.mimeData()) != (None, ()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        design, others = dropped_files(event.mimeData())
        if design is not None:
            event.acceptProposedAction()
            QTimer.singleShot(0, self, lambda: self.design_dropped.emit(design))
        if others:
            event.acceptProposedAction()
            QTimer.singleShot(0, self, lambda: self.others_dropped.emit(others))

    def focusNextPrevChild(self, next_: bool) -> bool:
        """Tab goes through the window as one reads it, whatever is in sight at the moment."""
        lay_way(self)
        return bool(super().focusNextPrevChild(next_))

    def closeEvent(self, event: QCloseEvent) -> None:
        if self._closed:
            event.accept()
            return
        if not self.may_close():
            event.ignore()
            return
        self._closed = True
        layout = self.layout_state()
        if self._settings is not None:
            self._settings.setValue("geometry", self.saveGeometry())
            self._settings.setValue("layout", layout)
        self.hide()
        self.closing.emit()
        self.analysis.close_pages()
        self.area.close_views()
        if self._settings is not None:
            self._settings.sync()
        event.accept()

    def _make_toolbar(self) -> None:
        toolbar = QToolBar(tr("Commands"))
        toolbar.setObjectName("commands")
        toolbar.setMovable(False)
        toolbar.setIconSize(QSize(20, 20))
        toolbar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        self.commands.fill_toolbar(toolbar)
        toolbar.addSeparator()
        self.method_bar.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        toolbar.addWidget(self.method_bar)
        self.addToolBar(toolbar)

    def _make_docks(self) -> None:
        for corner in (Qt.Corner.TopLeftCorner, Qt.Corner.BottomLeftCorner):
            self.setCorner(corner, LEFT)
        self.setCorner(Qt.Corner.BottomRightCorner, BOTTOM)
        self._docks = {
            self._dock(noted("Parameters"), self.form): LEFT,
            self._dock(noted("Derived values"), self.derived): LEFT,
            self._dock(noted("Layers"), self.sharing.shared("Layers", self.layer_panel)): RIGHT,
            self._dock(noted("Analysis"), self.analysis): BOTTOM,
        }
        self._solid_dock = self._dock(noted("Solid"), self.sharing.shared("Solid", self.solid_panel))
        movable = QDockWidget.DockWidgetFeature.DockWidgetMovable | QDockWidget.DockWidgetFeature.DockWidgetFloatable
        self._solid_dock.setFeatures(movable)
        self.addDockWidget(RIGHT, self._solid_dock)
        self._solid_dock.hide()
        analysis = list(self._docks)[-1]
        analysis.setTitleBarWidget(self.analysis.bar)
        self.analysis.tab_chosen.connect(lambda _tab: self._fit_analysis())
        self.analysis.expanded.connect(self._expand_analysis)
        for dock in self._docks:
            action = dock.toggleViewAction()
            action.setObjectName(f"panels.{dock.objectName()}")
            self.commands.panels.addAction(action)

    def _dock(self, title: str, widget: QWidget) -> QDockWidget:
        dock = QDockWidget(tr(title), self)
        dock.setObjectName(title)
        dock.setWidget(widget)
        return dock
