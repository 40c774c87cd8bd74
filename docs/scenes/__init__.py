"""Every state of the program that has words in it, one after the other, for whoever looks at the window."""
