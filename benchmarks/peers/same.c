/* Times the statements of the generated class, transliterated into C: see CText.java. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

/* SinCos.java, statement by statement. */
static inline void sinCos(double angle, double *out, int offset) {
  if (!(fabs(angle) <= 1e4)) {
    out[offset] = sin(angle);
    out[offset + 1] = cos(angle);
    return;
  }
  double n = rint(angle * 0x1.45f306dc9c883p-1);
  double first = angle - n * 0x1.921fb544p0;
  double second = n * 0x1.0b4611a6p-34;
  double partial = first - second;
  double third = n * 0x1.3198a2e037073p-69 - ((first - partial) - second);
  double x = partial - third;
  double tail = (partial - x) - third;
  double z = x * x;
  double half = 0.5 * z;
  double sinPolynomial = -0.16666666666666632 + z * (0.008333333333322398
      + z * (-0.0001984126982979409 + z * (2.755731368695442e-06
      + z * (-2.5050757308207942e-08 + z * 1.5896747244048834e-10))));
  double cosPolynomial = 0.0416666666666666 + z * (-0.00138888888888741
      + z * (2.4801587289467676e-05 + z * (-2.755731434795667e-07
      + z * (2.0875722654805672e-09 + z * -1.1359614629226544e-11))));
  double sine = x + (z * x * sinPolynomial + tail * (1 - half));
  double leading = 1 - half;
  double cosine = leading + (((1 - leading) - half) + (z * z * cosPolynomial - x * tail));
  int quadrant = (int) n & 3;
  double s = (quadrant & 1) == 0 ? sine : cosine;
  double c = (quadrant & 1) == 0 ? cosine : sine;
  out[offset] = quadrant >= 2 ? -s : s;
  out[offset + 1] = quadrant == 1 || quadrant == 2 ? -c : c;
}

#define REGULAR (-1)
#include MODEL

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1e9 * t.tv_sec + t.tv_nsec;
}

int main(int argc, char **argv) {
  static double y[STATES], yDot[STATES];
  FILE *state = fopen(argv[1], "r");
  for (int i = 0; i < STATES; i++)
    if (fscanf(state, "%lf", &y[i]) != 1) return 1;
  double found = 1e300, sign = 1e-9;
  for (int round = 0; round < 401; round++) {
    long count = 0;
    double begin = now(), ns;
    do {
      for (int i = 0; i < 8; i++) {
        y[0] += sign;
        sign = -sign;
        derivative(0, y, yDot);
      }
      count += 8;
      ns = now() - begin;
    } while (ns < 1.5e6);
    if (ns / count < found) found = ns / count;
  }
  printf("derivative %.1f\n", found);
  printf("value %.17g\n", yDot[STATES - 1]);
  return argc == 2 ? 0 : 2;
}
