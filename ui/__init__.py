"""The window: everything with Qt or VTK in it.

``session`` holds the state and knows no widget; widgets show state and emit what the user wants;
``controller`` is the only place that connects the two and the background process.
"""
