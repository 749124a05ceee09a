// Exercise 07.3: one sample in each cell
//
// A pixel is divided into n x n cells, and each of its n x n samples belongs to one of them. Sample
// i, counted from 0, is in column i % n and row i / n. Return its place, from (0, 0) to (1, 1)
// across the pixel. a and b are random, 0 or more and less than 1: they say where in the cell the
// sample is, across and up.
#include "exercise.hpp"

Uv place_of_sample(int i, int n, double a, double b) {
  // solution
  const int column = i % n;
  const int row = i / n;
  return {(column + a) / n, (row + b) / n};
  // start: // Your lines here.
  // start: return {a * i / n, b};
}
// hint: Count in cells first: the sample is at column + a.
// hint: n cells are as wide as the pixel, so divide by n.
