"""The report in the window: what goes in, a preview of its pages, the PDF."""
