"""Hypoid pairs: cones of offset axes, wheel flanks with a base cone each, and the pinion flanks conjugate to them.

Signs are those of the rest of the theory: a hand of +1 is right, azimuth growing with the distance from the apex.
"""
