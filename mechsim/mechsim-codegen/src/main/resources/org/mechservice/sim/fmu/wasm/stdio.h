#ifndef MECH_WASM_STDIO_H
#define MECH_WASM_STDIO_H
#include <stdarg.h>
#include <stddef.h>
int vsnprintf(char *text, size_t size, const char *format, va_list arguments);
#endif
