/* The functions of FMI 2.0 (Functional Mock-up Interface for Model Exchange and Co-Simulation,
 * version 2.0.5), declared after the tables of the standard. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mech_fmu.h"

#if defined(_WIN32)
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

/* A static library has the model's name before each function. */
#ifdef FMI2_FUNCTION_PREFIX
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define FMI2(name) JOIN(FMI2_FUNCTION_PREFIX, name)
#else
#define FMI2(name) name
#endif

typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char *fmi2String;
typedef char fmi2Byte;

typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum {
  fmi2DoStepStatus,
  fmi2PendingStatus,
  fmi2LastSuccessfulTime,
  fmi2Terminated
} fmi2StatusKind;

typedef void (*fmi2CallbackLogger)(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String,
                                   fmi2String, ...);

typedef struct {
  fmi2CallbackLogger logger;
  void *(*allocateMemory)(size_t, size_t);
  void (*freeMemory)(void *);
  void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

typedef struct {
  fmi2Boolean newDiscreteStatesNeeded;
  fmi2Boolean terminateSimulation;
  fmi2Boolean nominalsOfContinuousStatesChanged;
  fmi2Boolean valuesOfContinuousStatesChanged;
  fmi2Boolean nextEventTimeDefined;
  fmi2Real nextEventTime;
} fmi2EventInfo;

enum {
  BEFORE_RUN = MECH_INSTANTIATED | MECH_INITIALIZATION,
  READABLE = MECH_INITIALIZATION | MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING | MECH_STEP_FAILED |
             MECH_TERMINATED | MECH_ERROR,
  WRITABLE = BEFORE_RUN | MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING,
  ANY = READABLE | MECH_INSTANTIATED
};

/* Leaves a function that is called at the wrong time. */
#define REQUIRE(modes)                                \
  mech_instance *c = component;                       \
  if (!mech_may(c, __func__, (modes))) return fmi2Error

#define REQUIRE_KIND(cosim, modes)                                                          \
  REQUIRE(modes);                                                                           \
  if (c->co_simulation != (cosim))                                                          \
  return (fmi2Status)mech_say(c, MECH_FAILED, "%s: not a function of %s.", __func__,        \
                              c->co_simulation ? "Co-Simulation" : "Model Exchange")

#define REQUIRE_POINTER(pointer) \
  if ((pointer) == NULL)         \
  return (fmi2Status)mech_say(c, MECH_FAILED, "%s: a null pointer.", __func__)

EXPORT const char *FMI2(fmi2GetTypesPlatform)(void) { return "default"; }
EXPORT const char *FMI2(fmi2GetVersion)(void) { return "2.0"; }

static void to_logger(const mech_instance *c, mech_status status, const char *category,
                      const char *text) {
  union {
    void *pointer;
    fmi2CallbackLogger function;
  } logger;
  logger.pointer = c->logger;
  logger.function(c->environment, c->name, (fmi2Status)status, category, "%s", text);
}

EXPORT fmi2Status FMI2(fmi2SetDebugLogging)(fmi2Component component, fmi2Boolean on, size_t n,
                                            const fmi2String categories[]) {
  REQUIRE(ANY);
  (void)n;
  (void)categories;
  c->logging = on;
  return fmi2OK;
}

EXPORT fmi2Component FMI2(fmi2Instantiate)(fmi2String name, fmi2Type type, fmi2String guid,
                                           fmi2String resources,
                                           const fmi2CallbackFunctions *functions,
                                           fmi2Boolean visible, fmi2Boolean logging) {
  mech_instance *c;
  union {
    void *pointer;
    fmi2CallbackLogger function;
  } logger;
  const char *wrong = NULL;
  (void)resources;
  (void)visible;
  if (functions == NULL) {
    return NULL;
  }
  if (name == NULL || name[0] == 0) {
    wrong = "fmi2Instantiate: the instance has no name.";
  } else if (guid == NULL || strcmp(guid, MODEL_TOKEN) != 0) {
    wrong = "fmi2Instantiate: the GUID is not that of this binary: the modelDescription.xml is of"
            " another model.";
  } else if (type != fmi2ModelExchange && type != fmi2CoSimulation) {
    wrong = "fmi2Instantiate: neither Model Exchange nor Co-Simulation.";
  }
  if (wrong != NULL) {
    if (functions->logger != NULL) {
      functions->logger(functions->componentEnvironment, name == NULL ? "" : name, fmi2Error,
                        "logStatusError", "%s", wrong);
    }
    return NULL;
  }
  if (functions->allocateMemory != NULL && functions->freeMemory != NULL) {
    c = mech_create(functions->allocateMemory, functions->freeMemory, name);
  } else {
    c = mech_create(calloc, free, name);
  }
  if (c == NULL) {
    return NULL;
  }
  logger.function = functions->logger;
  c->logger = logger.pointer;
  c->log = functions->logger == NULL ? NULL : to_logger;
  c->environment = functions->componentEnvironment;
  c->co_simulation = type == fmi2CoSimulation;
  c->logging = logging;
  return c;
}

EXPORT void FMI2(fmi2FreeInstance)(fmi2Component component) { mech_free(component); }

EXPORT fmi2Status FMI2(fmi2SetupExperiment)(fmi2Component component, fmi2Boolean toleranceDefined,
                                            fmi2Real tolerance, fmi2Real start,
                                            fmi2Boolean stopDefined, fmi2Real stop) {
  REQUIRE(MECH_INSTANTIATED);
  return (fmi2Status)mech_set_up(c, toleranceDefined, tolerance, start, stopDefined, stop);
}

EXPORT fmi2Status FMI2(fmi2EnterInitializationMode)(fmi2Component component) {
  REQUIRE(MECH_INSTANTIATED);
  c->s.mode = MECH_INITIALIZATION;
  return fmi2OK;
}

EXPORT fmi2Status FMI2(fmi2ExitInitializationMode)(fmi2Component component) {
  mech_status status;
  REQUIRE(MECH_INITIALIZATION);
  status = mech_initialised(c);
  if (status == MECH_OK) {
    c->s.mode = c->co_simulation ? MECH_STEPPING : MECH_EVENT;
  } else if (status == MECH_FAILED) {
    c->s.mode = MECH_ERROR;
  }
  return (fmi2Status)status;
}

EXPORT fmi2Status FMI2(fmi2Terminate)(fmi2Component component) {
  REQUIRE(MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING | MECH_STEP_FAILED);
  c->s.mode = MECH_TERMINATED;
  return fmi2OK;
}

EXPORT fmi2Status FMI2(fmi2Reset)(fmi2Component component) {
  REQUIRE(ANY);
  mech_reset(c);
  return fmi2OK;
}

EXPORT fmi2Status FMI2(fmi2GetReal)(fmi2Component component, const fmi2ValueReference vr[],
                                    size_t n, fmi2Real value[]) {
  size_t i;
  mech_status status = MECH_OK;
  REQUIRE(READABLE);
  if (n > 0) {
    REQUIRE_POINTER(vr);
    REQUIRE_POINTER(value);
  }
  for (i = 0; i < n && status == MECH_OK; i++) {
    status = mech_get(c, __func__, vr[i], &value[i]);
  }
  return (fmi2Status)status;
}

EXPORT fmi2Status FMI2(fmi2SetReal)(fmi2Component component, const fmi2ValueReference vr[],
                                    size_t n, const fmi2Real value[]) {
  size_t i;
  mech_status status = MECH_OK;
  REQUIRE(WRITABLE);
  if (n > 0) {
    REQUIRE_POINTER(vr);
    REQUIRE_POINTER(value);
  }
  for (i = 0; i < n && status == MECH_OK; i++) {
    status = mech_set(c, __func__, vr[i], value[i]);
  }
  return (fmi2Status)status;
}

/* The model has variables of type Real only. */
#define NONE(name, type, modes)                                                               \
  EXPORT fmi2Status FMI2(name)(fmi2Component component, const fmi2ValueReference vr[],        \
                               size_t n, type value[]) {                                      \
    REQUIRE(modes);                                                                           \
    (void)value;                                                                              \
    if (n == 0) return fmi2OK;                                                                \
    REQUIRE_POINTER(vr);                                                                      \
    return (fmi2Status)mech_say(c, MECH_FAILED,                                               \
                                "%s: no variable of this type has the value reference %u.",   \
                                __func__, vr[0]);                                             \
  }

NONE(fmi2GetInteger, fmi2Integer, READABLE)
NONE(fmi2GetBoolean, fmi2Boolean, READABLE)
NONE(fmi2GetString, fmi2String, READABLE)
NONE(fmi2SetInteger, const fmi2Integer, WRITABLE)
NONE(fmi2SetBoolean, const fmi2Boolean, WRITABLE)
NONE(fmi2SetString, const fmi2String, WRITABLE)

EXPORT fmi2Status FMI2(fmi2GetFMUstate)(fmi2Component component, fmi2FMUstate *state) {
  REQUIRE(ANY);
  return (fmi2Status)mech_save(c, __func__, state);
}

EXPORT fmi2Status FMI2(fmi2SetFMUstate)(fmi2Component component, fmi2FMUstate state) {
  REQUIRE(ANY);
  return (fmi2Status)mech_restore(c, __func__, state);
}

EXPORT fmi2Status FMI2(fmi2FreeFMUstate)(fmi2Component component, fmi2FMUstate *state) {
  REQUIRE(ANY);
  return (fmi2Status)mech_discard(c, __func__, state);
}

EXPORT fmi2Status FMI2(fmi2SerializedFMUstateSize)(fmi2Component component, fmi2FMUstate state,
                                                   size_t *size) {
  REQUIRE(ANY);
  REQUIRE_POINTER(state);
  REQUIRE_POINTER(size);
  *size = mech_saved_size();
  return fmi2OK;
}

EXPORT fmi2Status FMI2(fmi2SerializeFMUstate)(fmi2Component component, fmi2FMUstate state,
                                              fmi2Byte bytes[], size_t size) {
  REQUIRE(ANY);
  return (fmi2Status)mech_serialize(c, __func__, state, bytes, size);
}

EXPORT fmi2Status FMI2(fmi2DeSerializeFMUstate)(fmi2Component component, const fmi2Byte bytes[],
                                                size_t size, fmi2FMUstate *state) {
  REQUIRE(ANY);
  return (fmi2Status)mech_deserialize(c, __func__, bytes, size, state);
}

EXPORT fmi2Status FMI2(fmi2GetDirectionalDerivative)(fmi2Component component,
                                                     const fmi2ValueReference unknown[],
                                                     size_t unknowns,
                                                     const fmi2ValueReference known[],
                                                     size_t knowns, const fmi2Real seed[],
                                                     fmi2Real sensitivity[]) {
  REQUIRE(MECH_INITIALIZATION | MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING | MECH_TERMINATED);
  return (fmi2Status)mech_directional(c, __func__, unknown, unknowns, known, knowns, seed, knowns,
                                      sensitivity, unknowns);
}

/* Model Exchange. */

EXPORT fmi2Status FMI2(fmi2EnterEventMode)(fmi2Component component) {
  REQUIRE_KIND(0, MECH_CONTINUOUS | MECH_EVENT);
  c->s.mode = MECH_EVENT;
  return fmi2OK;
}

EXPORT fmi2Status FMI2(fmi2NewDiscreteStates)(fmi2Component component, fmi2EventInfo *info) {
  int changed = 0;
  mech_status status;
  REQUIRE_KIND(0, MECH_EVENT);
  REQUIRE_POINTER(info);
  status = mech_update(c, &changed);
  memset(info, 0, sizeof *info);
  info->valuesOfContinuousStatesChanged = changed;
  info->terminateSimulation = c->s.terminate;
  if (mech_next_jump(c) < HUGE_VAL) {
    info->nextEventTimeDefined = 1;
    info->nextEventTime = mech_next_jump(c);
  }
  return (fmi2Status)status;
}

EXPORT fmi2Status FMI2(fmi2EnterContinuousTimeMode)(fmi2Component component) {
  mech_status status;
  REQUIRE_KIND(0, MECH_EVENT);
  status = mech_begin_continuous(c);
  if (status == MECH_OK) {
    c->s.mode = MECH_CONTINUOUS;
  }
  return (fmi2Status)status;
}

EXPORT fmi2Status FMI2(fmi2CompletedIntegratorStep)(fmi2Component component,
                                                    fmi2Boolean noSetFMUStatePriorToCurrentPoint,
                                                    fmi2Boolean *enterEventMode,
                                                    fmi2Boolean *terminateSimulation) {
  REQUIRE_KIND(0, MECH_CONTINUOUS);
  (void)noSetFMUStatePriorToCurrentPoint;
  REQUIRE_POINTER(enterEventMode);
  REQUIRE_POINTER(terminateSimulation);
  *terminateSimulation = c->s.terminate;
  return (fmi2Status)mech_step_completed(c, enterEventMode);
}

EXPORT fmi2Status FMI2(fmi2SetTime)(fmi2Component component, fmi2Real t) {
  REQUIRE_KIND(0, MECH_EVENT | MECH_CONTINUOUS);
  return (fmi2Status)mech_set_time(c, __func__, t);
}

EXPORT fmi2Status FMI2(fmi2SetContinuousStates)(fmi2Component component, const fmi2Real x[],
                                                size_t n) {
  REQUIRE_KIND(0, MECH_CONTINUOUS);
  return (fmi2Status)mech_set_states(c, __func__, x, n);
}

EXPORT fmi2Status FMI2(fmi2GetDerivatives)(fmi2Component component, fmi2Real dx[], size_t n) {
  REQUIRE_KIND(0, READABLE);
  return (fmi2Status)mech_get_derivatives(c, __func__, dx, n);
}

EXPORT fmi2Status FMI2(fmi2GetEventIndicators)(fmi2Component component, fmi2Real g[], size_t n) {
  REQUIRE_KIND(0, READABLE);
  return (fmi2Status)mech_get_indicators(c, __func__, g, n);
}

EXPORT fmi2Status FMI2(fmi2GetContinuousStates)(fmi2Component component, fmi2Real x[], size_t n) {
  REQUIRE_KIND(0, READABLE);
  return (fmi2Status)mech_get_states(c, __func__, x, n);
}

EXPORT fmi2Status FMI2(fmi2GetNominalsOfContinuousStates)(fmi2Component component, fmi2Real x[],
                                                          size_t n) {
  size_t i;
  REQUIRE_KIND(0, ANY);
  if (n != MODEL_NX || (n > 0 && x == NULL)) {
    return (fmi2Status)mech_say(c, MECH_FAILED, "%s: the model has %d states.", __func__, MODEL_NX);
  }
  for (i = 0; i < n; i++) {
    x[i] = 1;
  }
  return fmi2OK;
}

/* Co-Simulation. */

EXPORT fmi2Status FMI2(fmi2SetRealInputDerivatives)(fmi2Component component,
                                                    const fmi2ValueReference vr[], size_t n,
                                                    const fmi2Integer order[],
                                                    const fmi2Real value[]) {
  REQUIRE_KIND(1, MECH_INSTANTIATED | MECH_INITIALIZATION | MECH_STEPPING);
  (void)vr;
  (void)order;
  (void)value;
  return n == 0 ? fmi2OK
                : (fmi2Status)mech_say(c, MECH_FAILED, "%s: inputs are not interpolated.",
                                       __func__);
}

EXPORT fmi2Status FMI2(fmi2GetRealOutputDerivatives)(fmi2Component component,
                                                     const fmi2ValueReference vr[], size_t n,
                                                     const fmi2Integer order[], fmi2Real value[]) {
  REQUIRE_KIND(1, MECH_STEPPING | MECH_STEP_FAILED | MECH_TERMINATED | MECH_ERROR);
  (void)vr;
  (void)order;
  (void)value;
  return n == 0 ? fmi2OK
                : (fmi2Status)mech_say(c, MECH_FAILED, "%s: outputs have no derivatives here.",
                                       __func__);
}

EXPORT fmi2Status FMI2(fmi2DoStep)(fmi2Component component, fmi2Real t, fmi2Real size,
                                   fmi2Boolean noSetFMUStatePriorToCurrentPoint) {
  REQUIRE_KIND(1, MECH_STEPPING);
  (void)noSetFMUStatePriorToCurrentPoint;
  if (!(size > 0)) {
    return (fmi2Status)mech_say(c, MECH_FAILED, "%s: the step size is not positive.", __func__);
  }
  return (fmi2Status)mech_do_step(c, __func__, t, size);
}

EXPORT fmi2Status FMI2(fmi2CancelStep)(fmi2Component component) {
  REQUIRE_KIND(1, ANY);
  return (fmi2Status)mech_say(c, MECH_FAILED, "%s: steps do not run in the background.", __func__);
}

EXPORT fmi2Status FMI2(fmi2GetStatus)(fmi2Component component, const fmi2StatusKind kind,
                                      fmi2Status *value) {
  REQUIRE_KIND(1, ANY);
  (void)value;
  (void)kind;
  return (fmi2Status)mech_say(c, MECH_DISCARD, "%s: steps do not run in the background.",
                              __func__);
}

EXPORT fmi2Status FMI2(fmi2GetRealStatus)(fmi2Component component, const fmi2StatusKind kind,
                                          fmi2Real *value) {
  REQUIRE_KIND(1, ANY);
  REQUIRE_POINTER(value);
  if (kind == fmi2LastSuccessfulTime) {
    *value = c->s.t;
    return fmi2OK;
  }
  return (fmi2Status)mech_say(c, MECH_DISCARD, "%s: no such status.", __func__);
}

EXPORT fmi2Status FMI2(fmi2GetIntegerStatus)(fmi2Component component, const fmi2StatusKind kind,
                                             fmi2Integer *value) {
  REQUIRE_KIND(1, ANY);
  (void)value;
  (void)kind;
  return (fmi2Status)mech_say(c, MECH_DISCARD, "%s: no such status.", __func__);
}

EXPORT fmi2Status FMI2(fmi2GetBooleanStatus)(fmi2Component component, const fmi2StatusKind kind,
                                             fmi2Boolean *value) {
  REQUIRE_KIND(1, ANY);
  REQUIRE_POINTER(value);
  if (kind == fmi2Terminated) {
    *value = c->s.terminate;
    return fmi2OK;
  }
  return (fmi2Status)mech_say(c, MECH_DISCARD, "%s: no such status.", __func__);
}

EXPORT fmi2Status FMI2(fmi2GetStringStatus)(fmi2Component component, const fmi2StatusKind kind,
                                            fmi2String *value) {
  REQUIRE_KIND(1, ANY);
  (void)value;
  (void)kind;
  return (fmi2Status)mech_say(c, MECH_DISCARD, "%s: steps do not run in the background.",
                              __func__);
}
