/* Starts a thread when it is loaded, which a program that forks or counts its cores does not expect. */
#include <pthread.h>
#include <unistd.h>

#include "hostile.h"

static void* sleep_forever(void* nothing) {
  for (;;) pause();
  return nothing;
}
__attribute__((constructor)) static void start(void) {
  pthread_t thread;
  pthread_create(&thread, NULL, sleep_forever, NULL);
}

DRAG_LIBRARY("starts-thread", run_drag)
