// The field dictionary of riffle/fields.h at run time.
#pragma once

#include <string>
#include <vector>

#include "host/plugins/description.hpp"
#include "riffle/abi.h"

namespace riffle {

FieldDescription describe_field(const riffle_field& field);

// All fields of the dictionary, those of pairs included, in its order.
const std::vector<FieldDescription>& field_dictionary();

// nullptr when the dictionary has no field of that name; a plugin may invent it then.
const FieldDescription* dictionary_field(const std::string& name);

// Fields of a pair that the host makes from two positions and velocities ("distance", "approach", ...), and those that
// the kernel makes ("kernel", "kernel_gradient", ...): no pass may write them.
bool is_geometry_field(const std::string& name);
bool is_kernel_field(const std::string& name);

}  // namespace riffle
