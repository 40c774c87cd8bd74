"""How the 3D views show things: cameras of the panes, colours, surface quality, picking and pictures."""
