"""Help inside the program: the equation browser, the guide, the glossary, the tour."""
