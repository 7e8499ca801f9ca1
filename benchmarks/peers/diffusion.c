/*
 * Diffusion with reaction on a plate, by CVODE of SUNDIALS 6 with the sparse factors of KLU.
 *
 *   cc -O3 diffusion.c -lsundials_cvode -lsundials_sunlinsolklu -lsundials_nvecserial -lsundials_sunmatrixsparse -lm
 *   a.out points tolerance file
 *
 * Prints seconds of the clock, seconds of the processor, evaluations, steps and factorisations, and
 * writes the state at the end. The Jacobian is differenced: columns of one colour share no row, five
 * colours are enough; these evaluations are counted.
 */
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>
#include <time.h>

#define COLOURS 5
#define DIFFUSIVITY 0.1
#define END 0.5

static int m;
static double tolerance;
static long evaluations;

static void derivative(const double *u, double *rate) {
  double scale = DIFFUSIVITY * (m + 1) * (m + 1);
  for (int i = 0; i < m; i++) {
    for (int j = 0; j < m; j++) {
      int k = i * m + j;
      double flow = -4 * u[k];
      if (i > 0) flow += u[k - m];
      if (i < m - 1) flow += u[k + m];
      if (j > 0) flow += u[k - 1];
      if (j < m - 1) flow += u[k + 1];
      rate[k] = scale * flow + u[k] * (1 - u[k]);
    }
  }
}

static int right_hand_side(double t, N_Vector u, N_Vector rate, void *data) {
  (void)t, (void)data;
  evaluations++;
  derivative(N_VGetArrayPointer(u), N_VGetArrayPointer(rate));
  return 0;
}

static int jacobian(double t, N_Vector y, N_Vector rate, SUNMatrix matrix, void *data, N_Vector moved, N_Vector there,
                    N_Vector unused) {
  (void)t, (void)data, (void)unused;
  double *u = N_VGetArrayPointer(y), *f = N_VGetArrayPointer(rate);
  double *x = N_VGetArrayPointer(moved), *g = N_VGetArrayPointer(there);
  sunindextype *starts = SM_INDEXPTRS_S(matrix), *rows = SM_INDEXVALS_S(matrix);
  double *values = SM_DATA_S(matrix);
  int n = m * m;
  long next = 0;
  for (int k = 0; k < n; k++) {
    int i = k / m, j = k % m;
    starts[k] = next;
    if (i > 0) rows[next++] = k - m;
    if (j > 0) rows[next++] = k - 1;
    rows[next++] = k;
    if (j < m - 1) rows[next++] = k + 1;
    if (i < m - 1) rows[next++] = k + m;
  }
  starts[n] = next;
  for (int colour = 0; colour < COLOURS; colour++) {
    memcpy(x, u, n * sizeof(double));
    for (int k = 0; k < n; k++) {
      if ((k / m + 2 * (k % m)) % COLOURS == colour) x[k] += 1.5e-8 * fmax(fabs(u[k]), 1);
    }
    evaluations++;
    derivative(x, g);
    for (int k = 0; k < n; k++) {
      if ((k / m + 2 * (k % m)) % COLOURS == colour) {
        for (long p = starts[k]; p < starts[k + 1]; p++) values[p] = (g[rows[p]] - f[rows[p]]) / (x[k] - u[k]);
      }
    }
  }
  return 0;
}

static void require(int flag, const char *what) {
  if (flag < 0) {
    fprintf(stderr, "%s failed with %d\n", what, flag);
    exit(1);
  }
}

static double hump(int point) {
  double x = (point + 1.0) / (m + 1);
  return x * (1 - x);
}

static double seconds(clockid_t clock) {
  struct timespec now;
  clock_gettime(clock, &now);
  return now.tv_sec + 1e-9 * now.tv_nsec;
}

int main(int count, char **arguments) {
  if (count != 4) {
    fprintf(stderr, "usage: diffusion POINTS TOLERANCE FILE\n");
    return 2;
  }
  m = atoi(arguments[1]);
  tolerance = atof(arguments[2]);
  int n = m * m;
  SUNContext context;
  require(SUNContext_Create(NULL, &context), "SUNContext_Create");
  N_Vector u = N_VNew_Serial(n, context);
  for (int k = 0; k < n; k++) N_VGetArrayPointer(u)[k] = 16 * hump(k / m) * hump(k % m);
  double began = seconds(CLOCK_MONOTONIC);
  void *cvode = CVodeCreate(CV_BDF, context);
  require(CVodeInit(cvode, right_hand_side, 0, u), "CVodeInit");
  require(CVodeSStolerances(cvode, tolerance, tolerance), "CVodeSStolerances");
  SUNMatrix matrix = SUNSparseMatrix(n, n, 5L * n, CSC_MAT, context);
  SUNLinearSolver solver = SUNLinSol_KLU(u, matrix, context);
  require(SUNLinSol_KLUSetOrdering(solver, 0), "SUNLinSol_KLUSetOrdering");  /* AMD, faster here than COLAMD */
  require(CVodeSetLinearSolver(cvode, solver, matrix), "CVodeSetLinearSolver");
  require(CVodeSetJacFn(cvode, jacobian), "CVodeSetJacFn");
  require(CVodeSetMaxNumSteps(cvode, 100000), "CVodeSetMaxNumSteps");
  require(CVodeSetStopTime(cvode, END), "CVodeSetStopTime");
  double t;
  require(CVode(cvode, END, u, &t, CV_NORMAL), "CVode");
  double took = seconds(CLOCK_MONOTONIC) - began;
  long steps, factorisations;
  CVodeGetNumSteps(cvode, &steps);
  CVodeGetNumLinSolvSetups(cvode, &factorisations);
  printf("%.3f %.3f %ld %ld %ld\n", took, seconds(CLOCK_PROCESS_CPUTIME_ID), evaluations, steps, factorisations);
  FILE *out = fopen(arguments[3], "wb");
  for (int k = 0; k < n; k++) {
    unsigned char bytes[8], swapped[8];
    memcpy(bytes, N_VGetArrayPointer(u) + k, 8);
    for (int b = 0; b < 8; b++) swapped[b] = bytes[7 - b];
    fwrite(swapped, 1, 8, out);
  }
  fclose(out);
  return 0;
}
