// Small helpers of the graph: NULL-terminated tables as vectors.
#pragma once

#include <algorithm>
#include <vector>

namespace riffle {

template <class T>
std::vector<const T*> entries(const T* const* table) {
  std::vector<const T*> out;
  for (; table != nullptr && *table != nullptr; ++table) out.push_back(*table);
  return out;
}

template <class T>
void add_once(std::vector<T>& list, const T& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace riffle
