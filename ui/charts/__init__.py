"""Charts that can be read, copied and saved; ``records`` and ``raster`` need no window, the rest needs pyqtgraph."""
