/*
 * Runs a model in steps of communication:
 *
 *   searched END STEP [restored|serialised]
 *
 * and prints its state at the end, then the number of steps tried. "restored" runs five steps on from
 * the middle before it goes back to the state saved there; "serialised" goes on from the bytes of
 * the state in another instance. Messages are printed as they come.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mech_fmu.h"

static void said(const mech_instance *c, mech_status status, const char *category,
                 const char *text) {
  (void)c;
  (void)category;
  if (status != MECH_OK) {
    printf("said %s\n", text);
  }
}

static mech_instance *created(double end) {
  mech_instance *c = mech_create(calloc, free, "model");
  c->co_simulation = c->logging = 1;
  c->log = said;
  mech_set_up(c, 0, 0, MODEL_START, 1, end);
  c->s.mode = MECH_INITIALIZATION;
  if (mech_initialised(c) != MECH_OK) {
    exit(1);
  }
  c->s.mode = MECH_STEPPING;
  return c;
}

static void step(mech_instance *c, double size, long k, long count, double end) {
  double to = k + 1 == count ? end : MODEL_START + (double)(k + 1) * size;
  if (mech_do_step(c, "step", c->s.t, to - c->s.t) != MECH_OK) {
    printf("ended at %.17g\n", c->s.t);
    exit(1);
  }
}

int main(int words, char **word) {
  double end = atof(word[1]), size = atof(word[2]);
  long count = (long)ceil((end - MODEL_START) / size - 1e-9), k;
  const char *how = words > 3 ? word[3] : "";
  mech_instance *c = created(end);
  void *saved = NULL;
  int i;
  for (k = 0; k < count; k++) {
    if (k == count / 2 && how[0] != 0) {
      mech_save(c, "save", &saved);
      if (strcmp(how, "restored") == 0) {
        long more;
        for (more = k; more < k + 5 && more < count; more++) {
          step(c, size, more, count, end);
        }
      } else {
        size_t length = mech_saved_size();
        void *bytes = malloc(length);
        mech_serialize(c, "serialize", saved, bytes, length);
        mech_discard(c, "discard", &saved);
        mech_free(c);
        c = created(end);
        mech_deserialize(c, "deserialize", bytes, length, &saved);
        free(bytes);
      }
      mech_restore(c, "restore", saved);
      mech_discard(c, "discard", &saved);
    }
    step(c, size, k, count, end);
  }
  for (i = 0; i < MODEL_NX; i++) {
    printf("%.17g\n", c->s.x[i]);
  }
  printf("%g\n", c->s.method.tries);
  mech_free(c);
  return 0;
}
