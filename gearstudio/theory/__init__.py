"""The exact tooth: cones, spherical involute, lengthwise laws, flanks, profile and points; numpy alone."""
