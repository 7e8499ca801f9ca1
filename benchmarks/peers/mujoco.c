/* Forward dynamics by MuJoCo, unconstrained: the least that gives accelerations, and mj_forward. */
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1e9 * t.tv_sec + t.tv_nsec;
}

static void least(const mjModel *m, mjData *d) {
  mj_kinematics(m, d);
  mj_comPos(m, d);
  mj_crb(m, d);
  mj_factorM(m, d);
  mj_comVel(m, d);
  mj_rne(m, d, 0, d->qfrc_bias);
  for (int i = 0; i < m->nv; i++) d->qacc[i] = -d->qfrc_bias[i];
  mj_solveM(m, d, d->qacc, d->qacc, 1);
}

static double best(const mjModel *m, mjData *d, void (*work)(const mjModel *, mjData *)) {
  double found = 1e300, sign = 1e-9;
  for (int round = 0; round < 401; round++) {
    long count = 0;
    double begin = now(), ns;
    do {
      for (int i = 0; i < 8; i++) {
        d->qpos[0] += sign;
        sign = -sign;
        work(m, d);
      }
      count += 8;
      ns = now() - begin;
    } while (ns < 1.5e6);
    if (ns / count < found) found = ns / count;
  }
  return found;
}

int main(int argc, char **argv) {
  char error[1000];
  mjModel *m = mj_loadXML(argv[1], NULL, error, sizeof error);
  if (!m) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  mjData *d = mj_makeData(m);
  FILE *state = fopen(argv[2], "r");
  for (int i = 0; i < m->nq; i++)
    if (fscanf(state, "%lf", &d->qpos[i]) != 1) return 1;
  for (int i = 0; i < m->nv; i++)
    if (fscanf(state, "%lf", &d->qvel[i]) != 1) return 1;
  int last = 0;
  if (fscanf(state, "%d", &last) != 1) return 1;
  printf("derivative %.1f\n", best(m, d, least));
  printf("forward %.1f\n", best(m, d, mj_forward));
  least(m, d);
  printf("value %.17g\n", d->qacc[last]);
  return 0;
}
