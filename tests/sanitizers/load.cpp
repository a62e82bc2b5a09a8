// Loads a library as the host loads plugins and calls one of its functions by name: load LIBRARY FUNCTION.
#include <dlfcn.h>

#include <cstdio>

int main(int count, char** arguments) {
  if (count != 3) return 2;
  void* library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
  void* function = library ? dlsym(library, arguments[2]) : nullptr;
  if (!function) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 2;
  }
  std::printf("sum %g\n", reinterpret_cast<double (*)(int)>(function)(1000));
}
