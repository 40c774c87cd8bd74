"""The only door to the CAD kernel (build123d's OCP): arrays in, B-splines and files out."""
