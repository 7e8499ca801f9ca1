/* What the sources of a unit use of the C library, where there is none. */
#ifndef MECH_WASM_MATH_H
#define MECH_WASM_MATH_H
#define HUGE_VAL (__builtin_huge_val())
#define INFINITY (__builtin_inff())
#define NAN (__builtin_nanf(""))
#define fabs __builtin_fabs
#define floor __builtin_floor
#define rint __builtin_rint
#define sqrt __builtin_sqrt
#define signbit(x) __builtin_signbit(x)
#define copysign __builtin_copysign
double ldexp(double x, int power);
#endif
