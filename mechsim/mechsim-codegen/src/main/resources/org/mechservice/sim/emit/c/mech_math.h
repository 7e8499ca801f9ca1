/*
 * Elementary functions with the same bits on every machine and compiler.
 *
 * sin to hypot give the bits of Java's StrictMath, which follow the published algorithms of
 * fdlibm; sin_cos, power, choose and product are those of MechService's solver. The arithmetic is
 * IEEE 754 double precision, rounded to nearest; compile with -ffp-contract=off and never with
 * -ffast-math. Angles in rad.
 */
#ifndef MECH_MATH_H
#define MECH_MATH_H

#ifdef __cplusplus
extern "C" {
#endif

double mech_abs(double x);
double mech_sin(double x);
double mech_cos(double x);
double mech_asin(double x);
double mech_acos(double x);
double mech_atan(double x);
double mech_atan2(double y, double x);
double mech_exp(double x);
double mech_log(double x);
double mech_sinh(double x);
double mech_cosh(double x);
double mech_tanh(double x);
double mech_hypot(double x, double y);

/* Smaller and larger of two numbers: NaN if one is NaN; -0 is smaller than +0. */
double mech_min(double a, double b);
double mech_max(double a, double b);

/* -1, 0 or 1; zeros keep their sign, NaN stays NaN. */
double mech_signum(double x);

/* Largest whole number not above x. */
double mech_floor(double x);

/* a to the power of b. */
double mech_power(double a, double b);

/* x where a <= b, else y. */
double mech_choose(double a, double b, double x, double y);

/* a b, but 0 if one factor is 0, even if the other is infinite or NaN. */
double mech_product(double a, double b);

/* How many of the ascending numbers of a row are not above x; 0 if x is NaN. */
double mech_interval(const double *row, int count, double x);

/* Number index of a row, a whole number from 0 to count - 1. */
double mech_element(const double *row, int count, double index);

/* Abscissa of the point of a curve of cubics that is closest to (x, z). */
double mech_closest(const double *row, int count, double x, double z);

/* x where a <= b, else y, and x: numbers that a search has found. */
double mech_pick(double a, double b, double x, double y);
double mech_held(double x);

/* Angle from the first of two points to where a string through a ring touches the ring. */
double mech_touch(double l1, double l2, double psi, double radius, double tolerance);

/* Writes sine and cosine of one angle to out[0] and out[1], error below 1 ulp. */
void mech_sin_cos(double angle, double *out);

/* Each of them alone, with the same bits. */
double mech_sine(double angle);
double mech_cosine(double angle);

/* Normalises a set of four Euler parameters. */
void mech_normalize(double *e);

#ifdef __cplusplus
}
#endif

#endif
