// The kinds of Function besides formulas. Axes: 0 x, 1 y, 2 z, 3 t.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "host/manifest/function.hpp"

namespace riffle {

using FunctionPointer = std::shared_ptr<const Function::Implementation>;

FunctionPointer constant_values(double value);

// values[k] holds where breaks[k-1] <= coordinate < breaks[k]; one value more than breaks, breaks increase.
FunctionPointer piecewise_values(std::size_t axis, std::vector<double> breaks, std::vector<Function> values);

// Linear between the points (at[k], values[k]), `at` increasing; beyond its ends the first and last value, or NaN.
FunctionPointer table_values(std::size_t axis, std::vector<double> at, std::vector<double> values,
                             bool undefined_outside);

}  // namespace riffle
