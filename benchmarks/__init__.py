"""The timed promises, measured side by side in one run: ``make bench``."""
