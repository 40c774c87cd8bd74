"""Arrays in, arrays out: deviations and what will be read from them."""
