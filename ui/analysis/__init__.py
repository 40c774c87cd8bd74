"""The analysis part of the window: charts, contact, data sheet and measurement beside the comparison table."""
