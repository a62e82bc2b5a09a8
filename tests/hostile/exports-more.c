/* Built without hidden visibility: its helper becomes everybody's. */
#include "hostile.h"

double helper_of_mine(double x) {
  return x * x;
}

DRAG_LIBRARY("exports-more", run_drag)
