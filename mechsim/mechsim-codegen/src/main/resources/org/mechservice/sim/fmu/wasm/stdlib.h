#ifndef MECH_WASM_STDLIB_H
#define MECH_WASM_STDLIB_H
#include <stddef.h>
void *calloc(size_t count, size_t size);
void free(void *place);
#endif
