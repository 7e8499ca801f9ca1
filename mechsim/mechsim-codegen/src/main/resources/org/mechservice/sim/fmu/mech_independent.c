
/* Part of the quality at the start below which the coordinates no longer determine the others:
 * errors of the others are so many times as large. If it is below NEAR, and no state is found
 * beyond, it is the singular position that lies between. */
static const double LOST = 1e-3, NEAR = 0.1;
/* Failures in one step, however short the importer makes it, after which the same is meant. */
enum { MOST_FAILURES = 5 };

/* Difference of the change of velocities in a step from what accelerations make of them, relative
 * to both, above which the others have come to another branch: where the chosen coordinates turn
 * back, the others would, too, instead of going on. */
static const double OTHER_BRANCH = 1;

static void pick(const double *y, double *x) {
  int i;
  for (i = 0; i < mech_independent_NX; i++) {
    x[i] = y[STATE[i]];
  }
}

static void say_lost(mech_independent_t *m, double t, const double *y, const char *what) {
  unsigned char others[MODEL_NV];
  size_t used;
  int k;
  used = (size_t)snprintf(m->text, sizeof m->text, "the coordinates %s %s", CHOSEN, what);
  if (MODEL_choose(&m->full, t, y, others) == DEPENDENT && memcmp(others, GIVEN, MODEL_NV) != 0) {
    const char *before = ". Here others do: --coordinates independent:";
    for (k = 0; k < MODEL_NV && used < sizeof m->text; k++) {
      if (others[k] && (k == 0 || !others[k - 1] || NAME[k] != NAME[k - 1])) {
        used += (size_t)snprintf(m->text + used, sizeof m->text - used, "%s%s", before, NAME[k]);
        before = ",";
      }
    }
  }
  if (used < sizeof m->text) {
    snprintf(m->text + used, sizeof m->text - used,
             ". Build the unit without --coordinates: its state is then moved onto the loops");
  }
}

/* The whole state at (t, x), from the one last accepted; NULL if it is not determined. */
static double *complete(mech_independent_t *m, double t, const double *x) {
  int i, size = mech_independent_NX * (int)sizeof(double);
  const double *p = m->full.p, *u = m->full.u;
  if (m->y_known && t == m->t_known && memcmp(x, m->x_known, (size_t)size) == 0 &&
      memcmp(p, m->p_known, sizeof m->p_known) == 0 &&
      memcmp(u, m->u_known, sizeof m->u_known) == 0) {
    return m->y;
  }
  memcpy(m->y, m->accepted, sizeof m->y);
  for (i = 0; i < mech_independent_NX; i++) {
    m->y[STATE[i]] = x[i];
  }
  m->y_known = 0;
  if (m->stays_lost) {
    return NULL;
  }
  m->text[0] = 0;
  if (MODEL_complete(&m->full, t, m->y, GIVEN, &m->quality) < 0) {
    m->lost = ++m->failures >= MOST_FAILURES ||
              m->accepted_quality < NEAR * m->first_quality;
    say_lost(m, t, m->accepted,
             m->lost ? "no longer determine the others: the position is singular"
                     : "lead to no state on the loops (Newton's method does not converge); with"
                       " shorter steps they may");
    return NULL;
  }
  m->lost = 0;
  m->y_known = 1;
  m->t_known = t;
  memcpy(m->x_known, x, (size_t)size);
  memcpy(m->p_known, p, sizeof m->p_known);
  memcpy(m->u_known, u, sizeof m->u_known);
  return m->y;
}

/* Takes a whole state as the one from which others are found. */
static void take(mech_independent_t *m, double t, const double *y) {
  memmove(m->accepted, y, sizeof m->accepted);
  m->y_known = 0;
  m->t_accepted = t;
  m->rates_known = MODEL_derivatives(&m->full, t, m->accepted, m->rates) == 0;
}

/* Whether a step to a whole state is none of one motion. */
static int turns_back(mech_independent_t *m, double t, const double *y) {
  double rates[MODEL_NX], h = t - m->t_accepted, speed = 0, apart = 0;
  int k;
  if (!m->rates_known || !(h > 0) || MODEL_derivatives(&m->full, t, y, rates) < 0) {
    return 0;
  }
  for (k = 0; k < MODEL_NV; k++) {
    double v = fabs(m->accepted[V + k]) + fabs(y[V + k]);
    double gain = 0.5 * h * (m->rates[V + k] + rates[V + k]);
    double of = (v + h * (fabs(m->rates[V + k]) + fabs(rates[V + k]))) / UNIT[k];
    double by = fabs(y[V + k] - m->accepted[V + k] - gain) / UNIT[k];
    speed = of > speed ? of : speed;
    apart = by > apart ? by : apart;
  }
  return apart > 0.5 * OTHER_BRANCH * speed;
}

/* Changes a whole state by a function that returns 1 in bit 0 if it did. */
#define CHANGE(m, t, x, call)              \
  double *y = complete(m, t, x);           \
  int result = y == NULL ? -1 : (call);    \
  if (result > 0 && (result & 1)) {        \
    take(m, t, y);                         \
    pick(m->accepted, x);                  \
  }                                        \
  return result

void mech_independent_init(mech_independent_t *m) {
  memset(m, 0, sizeof *m);
  MODEL_init(&m->full);
}

int mech_independent_start(mech_independent_t *m, double t0, double *x) {
  int result = MODEL_start(&m->full, t0, m->accepted);
  m->y_known = m->rates_known = 0;
  pick(m->accepted, x);
  return result;
}

int mech_independent_derivatives(mech_independent_t *m, double t, const double *x, double *dx) {
  double rates[MODEL_NX];
  double *y = complete(m, t, x);
  if (y == NULL || MODEL_derivatives(&m->full, t, y, rates) < 0) {
    return -1;
  }
  pick(rates, dx);
  return 0;
}

int mech_independent_outputs(mech_independent_t *m, double t, const double *x, double *out) {
  double *y = complete(m, t, x);
  int i;
  if (y == NULL || MODEL_outputs(&m->full, t, y, out) < 0) {
    return -1;
  }
  for (i = 0; i < mech_independent_NY - MODEL_NY; i++) {
    out[MODEL_NY + i] = y[OTHER[i]];
  }
  return 0;
}

int mech_independent_event_values(mech_independent_t *m, double t, const double *x, double *g) {
  double *y = complete(m, t, x);
  return y == NULL ? -1 : MODEL_event_values(&m->full, t, y, g);
}

int mech_independent_event(mech_independent_t *m, const signed char *occurred, double t,
                           double *x) {
  CHANGE(m, t, x, MODEL_event(&m->full, occurred, t, y));
}

int mech_independent_begin(mech_independent_t *m, double t, double *x) {
  CHANGE(m, t, x, MODEL_begin(&m->full, t, y));
}

int mech_independent_go_on(mech_independent_t *m, double t, double *x) {
  CHANGE(m, t, x, MODEL_go_on(&m->full, t, y));
}

/* Nothing of an independent state is left to move but the length of Euler parameters. */
int mech_independent_project(mech_independent_t *m, double t, double *x) {
  double *y = complete(m, t, x);
  if (y == NULL) {
    return -1;
  }
  if (m->quality < LOST * m->first_quality) {
    m->lost = m->stays_lost = 1;
    say_lost(m, t, y, "hardly determine the others any more: the position is nearly singular");
    return -1;
  }
  if (turns_back(m, t, y)) {
    m->lost = m->accepted_quality < NEAR * m->first_quality;
    say_lost(m, t, m->accepted, "turn back, and the others do not: the position is singular");
    return -1;
  }
  if (BALLS) {
    pick(y, x);
    m->y_known = 0;
  }
  return BALLS;
}

/* The coordinates that are states are kept as far as possible, the others follow. */
int mech_independent_close(mech_independent_t *m, double t, double *x, const unsigned char *set) {
  unsigned char all[MODEL_NX] = {0};
  double y[MODEL_NX];
  int i;
  (void)set;
  memcpy(y, m->accepted, sizeof y);
  for (i = 0; i < mech_independent_NX; i++) {
    y[STATE[i]] = x[i];
    all[STATE[i]] = 1;
  }
  m->text[0] = 0;
  m->stays_lost = 0;
  if (MODEL_close(&m->full, t, y, all) < 0) {
    return -1;
  }
  take(m, t, y);
  pick(y, x);
  if (complete(m, t, x) == NULL) {
    return -1;
  }
  m->first_quality = m->accepted_quality = m->quality;
  return 1;
}

void mech_independent_accepted(mech_independent_t *m, double t, const double *x) {
  double *y = complete(m, t, x);
  if (y != NULL) {
    MODEL_accepted(&m->full, t, y);
    m->accepted_quality = m->quality;
    m->failures = 0;
    take(m, t, y);
  }
}

double mech_independent_next_jump(const mech_independent_t *m, double t) {
  return MODEL_next_jump(&m->full, t);
}

const char *mech_independent_failure(const mech_independent_t *m) {
  return m->text[0] != 0 ? m->text : MODEL_failure(&m->full);
}
