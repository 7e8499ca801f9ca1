/* What the methods of integration share, and which of them the model uses. */
#ifndef MECH_STEPS_H
#define MECH_STEPS_H

#include "mech_fmu_model.h"

#define MECH_N (MODEL_NX > 0 ? MODEL_NX : 1)

typedef enum {
  MECH_STEP_DONE,
  MECH_STEP_NOT_FINITE,
  MECH_STEP_TOO_SMALL,
  MECH_STEP_TOO_ACCURATE,
  MECH_STEP_TOO_MANY
} mech_step_result;

#endif
