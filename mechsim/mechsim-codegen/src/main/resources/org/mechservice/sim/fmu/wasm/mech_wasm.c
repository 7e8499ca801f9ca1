/* A model as a WebAssembly module without imports: the integrator of Co-Simulation with its events,
 * and what it needs of a C library.
 *
 * Set numbers at mech_parameters() and mech_starts(), call mech_run, read rows at mech_rows(): time,
 * states, outputs. Start values that are not marked at mech_set() follow from the model. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mech_fmu.h"

#define EXPORT(name) __attribute__((export_name(#name)))

enum { PAGE = 65536, COLUMNS = 1 + MODEL_NX + MODEL_NY, KEPT_EVENTS = 4096 };

extern unsigned char __heap_base;

/* ---- what there is of a C library ---- */

__attribute__((no_builtin("memset", "memcpy", "memmove"))) void *memset(void *to, int value,
                                                                        size_t n) {
  unsigned char *t = to;
  while (n-- > 0) {
    *t++ = (unsigned char)value;
  }
  return to;
}

__attribute__((no_builtin("memset", "memcpy", "memmove"))) void *memmove(void *to, const void *from,
                                                                         size_t n) {
  unsigned char *t = to;
  const unsigned char *f = from;
  if (t <= f) {
    while (n-- > 0) {
      *t++ = *f++;
    }
  } else {
    while (n-- > 0) {
      t[n] = f[n];
    }
  }
  return to;
}

__attribute__((no_builtin("memset", "memcpy", "memmove"))) void *memcpy(void *to, const void *from,
                                                                        size_t n) {
  unsigned char *t = to;
  const unsigned char *f = from;
  while (n-- > 0) {
    *t++ = *f++;
  }
  return to;
}

int memcmp(const void *a, const void *b, size_t n) {
  const unsigned char *x = a, *y = b;
  for (; n > 0; n--, x++, y++) {
    if (*x != *y) {
      return *x < *y ? -1 : 1;
    }
  }
  return 0;
}

size_t strlen(const char *text) {
  size_t n = 0;
  while (text[n] != 0) {
    n++;
  }
  return n;
}

char *strcpy(char *to, const char *from) {
  memcpy(to, from, strlen(from) + 1);
  return to;
}

double ldexp(double x, int power) {
  double factor = power < 0 ? 0.5 : 2;
  int n = power < 0 ? -power : power;
  for (; n > 0; n--) {
    x *= factor;
  }
  return x;
}

/* Memory is taken from the end of the module's own and never given back: a module has one instance. */
static size_t taken;

void *calloc(size_t count, size_t size) {
  size_t bytes = (count * size + 15) / 16 * 16, from;
  if (taken == 0) {
    taken = ((size_t)&__heap_base + 15) / 16 * 16;
  }
  from = taken;
  while (from + bytes > __builtin_wasm_memory_size(0) * (size_t)PAGE) {
    size_t more = (from + bytes + PAGE - 1) / PAGE - __builtin_wasm_memory_size(0);
    if (__builtin_wasm_memory_grow(0, more) == (size_t)-1) {
      return NULL;
    }
  }
  taken = from + bytes;
  memset((void *)from, 0, bytes);
  return (void *)from;
}

void free(void *place) { (void)place; }

static char *digits(char *at, unsigned long long number) {
  char reversed[24];
  int n = 0;
  do {
    reversed[n++] = (char)('0' + number % 10);
    number /= 10;
  } while (number > 0);
  while (n > 0) {
    *at++ = reversed[--n];
  }
  return at;
}

/* Nine significant digits: enough for a message. */
static char *decimal(char *at, double x) {
  int power = 0, i;
  unsigned long long mantissa;
  char shown[24], *end;
  if (x != x) {
    return strcpy(at, "nan") + 3;
  }
  if (x < 0) {
    *at++ = '-';
    x = -x;
  }
  if (x > DBL_MAX) {
    return strcpy(at, "inf") + 3;
  }
  while (x >= 10) {
    x /= 10;
    power++;
  }
  while (x > 0 && x < 1) {
    x *= 10;
    power--;
  }
  mantissa = (unsigned long long)(x * 1e8 + 0.5);
  end = digits(shown, mantissa);
  while (end > shown + 1 && end[-1] == '0') {
    end--;
  }
  *at++ = shown[0];
  if (end > shown + 1) {
    *at++ = '.';
    for (i = 1; shown + i < end; i++) {
      *at++ = shown[i];
    }
  }
  if (power != 0) {
    *at++ = 'e';
    if (power < 0) {
      *at++ = '-';
    }
    at = digits(at, (unsigned long long)(power < 0 ? -power : power));
  }
  return at;
}

/* The conversions that messages use: s, d, u, lu, g with or without precision. */
int vsnprintf(char *text, size_t size, const char *format, va_list arguments) {
  char *at = text, *last = text + size - 40;
  for (; *format != 0 && at < last; format++) {
    if (*format != '%') {
      *at++ = *format;
      continue;
    }
    format++;
    while (*format == '.' || (*format >= '0' && *format <= '9') || *format == 'l') {
      format++;
    }
    if (*format == 's') {
      const char *from = va_arg(arguments, const char *);
      while (*from != 0 && at < last) {
        *at++ = *from++;
      }
    } else if (*format == 'g') {
      at = decimal(at, va_arg(arguments, double));
    } else if (*format == 'd') {
      int number = va_arg(arguments, int);
      if (number < 0) {
        *at++ = '-';
      }
      at = digits(at, number < 0 ? 0ULL - (unsigned long long)number : (unsigned long long)number);
    } else if (*format == 'u') {
      at = digits(at, va_arg(arguments, unsigned));
    } else {
      *at++ = *format;
    }
  }
  *at = 0;
  return (int)(at - text);
}

/* ---- the module ---- */

static mech_instance *instance;
static double parameters[MODEL_NP > 0 ? MODEL_NP : 1], starts[MECH_N];
static unsigned char set[MECH_N];
static char message[512];
static double *rows;
static size_t room;
static double event_times[KEPT_EVENTS];
static int event_numbers[KEPT_EVENTS];
static int event_count;

static void said(const mech_instance *c, mech_status status, const char *category,
                 const char *text) {
  (void)c;
  (void)status;
  (void)category;
  if (message[0] == 0) {
    memcpy(message, text, strlen(text) + 1);
  }
}

static void noted(const mech_instance *c, int event) {
  if (event_count < KEPT_EVENTS) {
    event_times[event_count] = c->s.t;
    event_numbers[event_count] = event;
    event_count++;
  }
}

static mech_instance *created(void) {
  if (instance == NULL) {
    instance = mech_create(calloc, free, "model");
    if (instance != NULL) {
      instance->co_simulation = 1;
      instance->log = said;
      instance->noted = noted;
    }
  }
  return instance;
}

/* Sets parameters and start values to those of the model. Returns 0, or -1 without memory. */
EXPORT(mech_reset_values) int mech_reset_values(void) {
  int i;
  mech_instance *c = created();
  if (c == NULL) {
    return -1;
  }
  mech_reset(c);
  MODEL_start(&c->s.model, MODEL_START, starts);
  memset(set, 0, sizeof set);
  for (i = 0; i < MODEL_NP; i++) {
    parameters[i] = c->s.model.p[i];
  }
  return 0;
}

EXPORT(mech_parameters) double *mech_parameters(void) { return parameters; }
EXPORT(mech_starts) double *mech_starts(void) { return starts; }
EXPORT(mech_set) unsigned char *mech_set_marks(void) { return set; }
EXPORT(mech_rows) double *mech_rows(void) { return rows; }
EXPORT(mech_message) const char *mech_message(void) { return message; }
EXPORT(mech_event_times) double *mech_event_times(void) { return event_times; }
EXPORT(mech_event_numbers) int *mech_event_numbers(void) { return event_numbers; }

/* Number of events in the last run, at most 4096: the later ones are not kept. */
EXPORT(mech_event_count) int mech_event_count(void) { return event_count; }

/* Numbers of states, parameters, outputs: what = 0, 1, 2. */
EXPORT(mech_count) int mech_count(int what) {
  return what == 0 ? MODEL_NX : what == 1 ? MODEL_NP : MODEL_NY;
}

/* Integrates from one time to another and writes a row at the start, after each step of the given
 * size and at the end. Returns the number of rows, less than asked for if the run ended before;
 * mech_message says why, and is empty after an event that ends the run. */
EXPORT(mech_run) int mech_run(double from, double to, double step, double rtol) {
  mech_instance *c = created();
  int row, count, i;
  message[0] = 0;
  event_count = 0;
  if (c == NULL || !(step > 0) || !(to > from) || !((to - from) / step < 1e6)) {
    strcpy(message, "These are not the times of a run.");
    return 0;
  }
  count = 1 + (int)((to - from) / step * (1 + 1e-12));
  if (from + step * (count - 1) < to - 1e-9 * step) {
    count++;
  }
  if ((size_t)count > room) {
    rows = calloc((size_t)count * COLUMNS, sizeof(double));
    room = rows == NULL ? 0 : (size_t)count;
    if (rows == NULL) {
      strcpy(message, "There is no memory for so many rows.");
      return 0;
    }
  }
  mech_reset(c);
#if MODEL_NP > 0
  memcpy(c->s.model.p, parameters, sizeof parameters);
#endif
  if (mech_set_up(c, 1, rtol, from, 1, to) != MECH_OK) {
    return 0;
  }
  for (i = 0; i < MODEL_NX; i++) {
    if (set[i]) {
      c->s.x[i] = starts[i];
      c->s.set[i] = 1;
    }
  }
  c->s.mode = MECH_INITIALIZATION;
  if (mech_initialised(c) != MECH_OK) {
    return 0;
  }
  c->s.mode = MECH_STEPPING;
  for (row = 0; row < count; row++) {
    double *at = rows + (size_t)row * COLUMNS;
    if (row > 0) {
      double end = row == count - 1 ? to : from + step * row;
      if (mech_do_step(c, "mech_run", c->s.t, end - c->s.t) != MECH_OK) {
        return row;
      }
    }
    at[0] = c->s.t;
    memcpy(at + 1, c->s.x, MODEL_NX * sizeof(double));
    for (i = 0; i < MODEL_NY; i++) {
      if (mech_get(c, "mech_run", (unsigned)(MECH_OUTPUT + i), at + 1 + MODEL_NX + i) != MECH_OK) {
        return row;
      }
    }
  }
  return count;
}
