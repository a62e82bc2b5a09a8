/* A shared library, but no plugin. That it was not loaded shows in the environment: its initialiser would end the
 * program. */
#include <stdlib.h>

__attribute__((constructor)) static void end_program(void) {
  _Exit(77);
}
