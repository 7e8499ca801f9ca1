/*
 * Runs a unit for Co-Simulation (FMI 2.0) from 0 to an end in equal steps:
 *
 *   host LIBRARY TOKEN END STEPS REFERENCE...
 *
 * prints "value X" for each variable at the end, and before that every message of the unit with a
 * status above OK, and "ended" if a call fails.
 */
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

typedef void *Component;
typedef int Status;
typedef void (*Logger)(void *, const char *, Status, const char *, const char *, ...);
typedef struct {
  Logger logger;
  void *(*allocate)(size_t, size_t);
  void (*release)(void *);
  void (*finished)(void *, Status);
  void *environment;
} Callbacks;

static void say(void *environment, const char *name, Status status, const char *category,
                const char *text, ...) {
  va_list values;
  (void)environment;
  (void)name;
  (void)category;
  if (status > 0) {
    va_start(values, text);
    vprintf(text, values);
    va_end(values);
    printf("\n");
  }
}

static void *function(void *library, const char *name) {
  void *found = dlsym(library, name);
  if (!found) {
    printf("no function %s\n", name);
    exit(1);
  }
  return found;
}

static void check(Status status) {
  if (status > 1) {
    printf("ended\n");
    exit(1);
  }
}

int main(int count, char **words) {
  Callbacks callbacks = {say, calloc, free, NULL, NULL};
  void *library = dlopen(words[1], RTLD_NOW);
  if (!library) {
    printf("%s\n", dlerror());
    return 1;
  }
  Component (*instantiate)(const char *, int, const char *, const char *, const Callbacks *, int, int) =
      function(library, "fmi2Instantiate");
  Status (*set_up)(Component, int, double, double, int, double) =
      function(library, "fmi2SetupExperiment");
  Status (*enter)(Component) = function(library, "fmi2EnterInitializationMode");
  Status (*leave)(Component) = function(library, "fmi2ExitInitializationMode");
  Status (*step)(Component, double, double, int) = function(library, "fmi2DoStep");
  Status (*get)(Component, const unsigned *, size_t, double *) = function(library, "fmi2GetReal");
  double end = atof(words[3]);
  int steps = atoi(words[4]);
  Component unit = instantiate("unit", 1, words[2], NULL, &callbacks, 0, 1);
  if (!unit) {
    printf("no instance\n");
    return 1;
  }
  check(set_up(unit, 0, 0, 0, 1, end));
  check(enter(unit));
  check(leave(unit));
  for (int k = 0; k < steps; k++) {
    double from = end * k / steps;
    check(step(unit, from, end * (k + 1) / steps - from, 1));
  }
  for (int i = 5; i < count; i++) {
    unsigned reference = (unsigned)strtoul(words[i], NULL, 10);
    double value;
    check(get(unit, &reference, 1, &value));
    printf("value %.17g\n", value);
  }
  return 0;
}
