/* The functions of FMI 3.0 (Functional Mock-up Interface, version 3.0.2), declared after the tables
 * of the standard. */
#include <stdbool.h>
#include <stdint.h>
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
#ifdef FMI3_FUNCTION_PREFIX
#define JOIN_(a, b) a##b
#define JOIN(a, b) JOIN_(a, b)
#define FMI3(name) JOIN(FMI3_FUNCTION_PREFIX, name)
#else
#define FMI3(name) name
#endif

typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef const char *fmi3String;
typedef uint8_t fmi3Byte;
typedef const fmi3Byte *fmi3Binary;
typedef bool fmi3Clock;

typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef enum {
  fmi3Independent,
  fmi3Constant,
  fmi3Fixed,
  fmi3Tunable,
  fmi3Discrete,
  fmi3Dependent
} fmi3DependencyKind;
typedef enum {
  fmi3IntervalNotYetKnown,
  fmi3IntervalUnchanged,
  fmi3IntervalChanged
} fmi3IntervalQualifier;

typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String, fmi3String);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, fmi3Float64, fmi3Boolean,
                                               fmi3Boolean, fmi3Boolean, fmi3Boolean, fmi3Boolean *,
                                               fmi3Float64 *);
typedef void (*fmi3Callback)(fmi3InstanceEnvironment);
typedef void (*fmi3Preemption)(void);

enum {
  BEFORE_RUN = MECH_INSTANTIATED | MECH_INITIALIZATION,
  READABLE = MECH_INITIALIZATION | MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING | MECH_STEP_FAILED |
             MECH_TERMINATED | MECH_ERROR,
  WRITABLE = BEFORE_RUN | MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING,
  ANY = READABLE | MECH_INSTANTIATED
};

/* Leaves a function that is called at the wrong time. */
#define REQUIRE(modes)             \
  mech_instance *c = instance;     \
  if (!mech_may(c, __func__, (modes))) return fmi3Error

#define REQUIRE_KIND(cosim, modes)                                                   \
  REQUIRE(modes);                                                                    \
  if (c->co_simulation != (cosim))                                                   \
  return (fmi3Status)mech_say(c, MECH_FAILED, "%s: not a function of %s.", __func__, \
                              c->co_simulation ? "Co-Simulation" : "Model Exchange")

#define REQUIRE_POINTER(pointer) \
  if ((pointer) == NULL)         \
  return (fmi3Status)mech_say(c, MECH_FAILED, "%s: a null pointer.", __func__)

#define REFUSE(why) return (fmi3Status)mech_say(c, MECH_FAILED, "%s: " why, __func__)

EXPORT const char *FMI3(fmi3GetVersion)(void) { return "3.0"; }

static void to_logger(const mech_instance *c, mech_status status, const char *category,
                      const char *text) {
  union {
    void *pointer;
    fmi3LogMessageCallback function;
  } logger;
  logger.pointer = c->logger;
  logger.function(c->environment, (fmi3Status)status, category, text);
}

EXPORT fmi3Status FMI3(fmi3SetDebugLogging)(fmi3Instance instance, fmi3Boolean on, size_t n,
                                            const fmi3String categories[]) {
  REQUIRE(ANY);
  (void)n;
  (void)categories;
  c->logging = on;
  return fmi3OK;
}

static fmi3Instance instantiate(int co_simulation, fmi3String name, fmi3String token,
                                fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                fmi3LogMessageCallback log) {
  mech_instance *c;
  union {
    void *pointer;
    fmi3LogMessageCallback function;
  } logger;
  const char *wrong = NULL;
  if (name == NULL || name[0] == 0) {
    wrong = "fmi3Instantiate: the instance has no name.";
  } else if (token == NULL || strcmp(token, MODEL_TOKEN) != 0) {
    wrong = "fmi3Instantiate: the instantiation token is not that of this binary: the"
            " modelDescription.xml is of another model.";
  }
  if (wrong != NULL) {
    if (log != NULL) {
      log(environment, fmi3Error, "logStatusError", wrong);
    }
    return NULL;
  }
  c = mech_create(calloc, free, name);
  if (c == NULL) {
    return NULL;
  }
  logger.function = log;
  c->logger = logger.pointer;
  c->log = log == NULL ? NULL : to_logger;
  c->environment = environment;
  c->co_simulation = co_simulation;
  c->logging = logging;
  return c;
}

EXPORT fmi3Instance FMI3(fmi3InstantiateModelExchange)(fmi3String name, fmi3String token,
                                                       fmi3String resources, fmi3Boolean visible,
                                                       fmi3Boolean logging,
                                                       fmi3InstanceEnvironment environment,
                                                       fmi3LogMessageCallback log) {
  (void)resources;
  (void)visible;
  return instantiate(0, name, token, logging, environment, log);
}

EXPORT fmi3Instance FMI3(fmi3InstantiateCoSimulation)(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
    fmi3Boolean logging, fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed,
    const fmi3ValueReference required[], size_t n, fmi3InstanceEnvironment environment,
    fmi3LogMessageCallback log, fmi3IntermediateUpdateCallback update) {
  (void)resources;
  (void)visible;
  (void)earlyReturnAllowed;
  (void)required;
  (void)n;
  (void)update;
  if (eventModeUsed) {
    if (log != NULL) {
      log(environment, fmi3Error, "logStatusError",
          "fmi3InstantiateCoSimulation: events are handled inside a step; there is no event mode.");
    }
    return NULL;
  }
  return instantiate(1, name, token, logging, environment, log);
}

EXPORT fmi3Instance FMI3(fmi3InstantiateScheduledExecution)(
    fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
    fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    fmi3Callback clock, fmi3Preemption lock, fmi3Preemption unlock) {
  (void)name;
  (void)token;
  (void)resources;
  (void)visible;
  (void)logging;
  (void)clock;
  (void)lock;
  (void)unlock;
  if (log != NULL) {
    log(environment, fmi3Error, "logStatusError", "The model has no Scheduled Execution.");
  }
  return NULL;
}

EXPORT void FMI3(fmi3FreeInstance)(fmi3Instance instance) { mech_free(instance); }

EXPORT fmi3Status FMI3(fmi3EnterInitializationMode)(fmi3Instance instance,
                                                    fmi3Boolean toleranceDefined,
                                                    fmi3Float64 tolerance, fmi3Float64 start,
                                                    fmi3Boolean stopDefined, fmi3Float64 stop) {
  mech_status status;
  REQUIRE(MECH_INSTANTIATED);
  status = mech_set_up(c, toleranceDefined, tolerance, start, stopDefined, stop);
  if (status == MECH_OK) {
    c->s.mode = MECH_INITIALIZATION;
  }
  return (fmi3Status)status;
}

EXPORT fmi3Status FMI3(fmi3ExitInitializationMode)(fmi3Instance instance) {
  mech_status status;
  REQUIRE(MECH_INITIALIZATION);
  status = mech_initialised(c);
  if (status == MECH_OK) {
    c->s.mode = c->co_simulation ? MECH_STEPPING : MECH_EVENT;
  } else if (status == MECH_FAILED) {
    c->s.mode = MECH_ERROR;
  }
  return (fmi3Status)status;
}

EXPORT fmi3Status FMI3(fmi3EnterEventMode)(fmi3Instance instance) {
  REQUIRE_KIND(0, MECH_CONTINUOUS | MECH_EVENT);
  c->s.mode = MECH_EVENT;
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3Terminate)(fmi3Instance instance) {
  REQUIRE(MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING | MECH_STEP_FAILED);
  c->s.mode = MECH_TERMINATED;
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3Reset)(fmi3Instance instance) {
  REQUIRE(ANY);
  mech_reset(c);
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3GetFloat64)(fmi3Instance instance, const fmi3ValueReference vr[],
                                       size_t n, fmi3Float64 values[], size_t count) {
  size_t i;
  mech_status status = MECH_OK;
  REQUIRE(READABLE);
  if (n != count) {
    REFUSE("as many values as value references are needed.");
  }
  if (n > 0) {
    REQUIRE_POINTER(vr);
    REQUIRE_POINTER(values);
  }
  for (i = 0; i < n && status == MECH_OK; i++) {
    status = mech_get(c, __func__, vr[i], &values[i]);
  }
  return (fmi3Status)status;
}

EXPORT fmi3Status FMI3(fmi3SetFloat64)(fmi3Instance instance, const fmi3ValueReference vr[],
                                       size_t n, const fmi3Float64 values[], size_t count) {
  size_t i;
  mech_status status = MECH_OK;
  REQUIRE(WRITABLE);
  if (n != count) {
    REFUSE("as many values as value references are needed.");
  }
  if (n > 0) {
    REQUIRE_POINTER(vr);
    REQUIRE_POINTER(values);
  }
  for (i = 0; i < n && status == MECH_OK; i++) {
    status = mech_set(c, __func__, vr[i], values[i]);
  }
  return (fmi3Status)status;
}

/* The model has variables of type Float64 only. */
#define NONE(name, type, modes)                                                               \
  EXPORT fmi3Status FMI3(name)(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, \
                               type values[], size_t count) {                                  \
    REQUIRE(modes);                                                                            \
    (void)values;                                                                              \
    if (n == 0 && count == 0) return fmi3OK;                                                   \
    REQUIRE_POINTER(vr);                                                                       \
    REFUSE("the model has variables of type Float64 only.");                                   \
  }

NONE(fmi3GetFloat32, fmi3Float32, READABLE)
NONE(fmi3SetFloat32, const fmi3Float32, WRITABLE)
NONE(fmi3GetInt8, fmi3Int8, READABLE)
NONE(fmi3SetInt8, const fmi3Int8, WRITABLE)
NONE(fmi3GetUInt8, fmi3UInt8, READABLE)
NONE(fmi3SetUInt8, const fmi3UInt8, WRITABLE)
NONE(fmi3GetInt16, fmi3Int16, READABLE)
NONE(fmi3SetInt16, const fmi3Int16, WRITABLE)
NONE(fmi3GetUInt16, fmi3UInt16, READABLE)
NONE(fmi3SetUInt16, const fmi3UInt16, WRITABLE)
NONE(fmi3GetInt32, fmi3Int32, READABLE)
NONE(fmi3SetInt32, const fmi3Int32, WRITABLE)
NONE(fmi3GetUInt32, fmi3UInt32, READABLE)
NONE(fmi3SetUInt32, const fmi3UInt32, WRITABLE)
NONE(fmi3GetInt64, fmi3Int64, READABLE)
NONE(fmi3SetInt64, const fmi3Int64, WRITABLE)
NONE(fmi3GetUInt64, fmi3UInt64, READABLE)
NONE(fmi3SetUInt64, const fmi3UInt64, WRITABLE)
NONE(fmi3GetBoolean, fmi3Boolean, READABLE)
NONE(fmi3SetBoolean, const fmi3Boolean, WRITABLE)
NONE(fmi3GetString, fmi3String, READABLE)
NONE(fmi3SetString, const fmi3String, WRITABLE)

EXPORT fmi3Status FMI3(fmi3GetBinary)(fmi3Instance instance, const fmi3ValueReference vr[],
                                      size_t n, size_t sizes[], fmi3Binary values[],
                                      size_t count) {
  REQUIRE(READABLE);
  (void)vr;
  (void)sizes;
  (void)values;
  if (n == 0 && count == 0) {
    return fmi3OK;
  }
  REFUSE("the model has variables of type Float64 only.");
}

EXPORT fmi3Status FMI3(fmi3SetBinary)(fmi3Instance instance, const fmi3ValueReference vr[],
                                      size_t n, const size_t sizes[], const fmi3Binary values[],
                                      size_t count) {
  REQUIRE(WRITABLE);
  (void)vr;
  (void)sizes;
  (void)values;
  if (n == 0 && count == 0) {
    return fmi3OK;
  }
  REFUSE("the model has variables of type Float64 only.");
}

/* The model has no clocks. */
#define NO_CLOCK(name, ...)                                                               \
  EXPORT fmi3Status FMI3(name)(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, \
                               __VA_ARGS__) {                                             \
    REQUIRE(ANY);                                                                         \
    (void)vr;                                                                             \
    (void)a;                                                                              \
    if (n == 0) return fmi3OK;                                                            \
    REFUSE("the model has no clocks.");                                                   \
  }

NO_CLOCK(fmi3GetClock, fmi3Clock a[])
NO_CLOCK(fmi3SetClock, const fmi3Clock a[])
NO_CLOCK(fmi3GetShiftDecimal, fmi3Float64 a[])
NO_CLOCK(fmi3SetShiftDecimal, const fmi3Float64 a[])
NO_CLOCK(fmi3SetIntervalDecimal, const fmi3Float64 a[])

#define NO_CLOCK_2(name, type_a, type_b)                                                       \
  EXPORT fmi3Status FMI3(name)(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, \
                               type_a a[], type_b b[]) {                                       \
    REQUIRE(ANY);                                                                              \
    (void)vr;                                                                                  \
    (void)a;                                                                                   \
    (void)b;                                                                                   \
    if (n == 0) return fmi3OK;                                                                 \
    REFUSE("the model has no clocks.");                                                        \
  }

NO_CLOCK_2(fmi3GetIntervalDecimal, fmi3Float64, fmi3IntervalQualifier)
NO_CLOCK_2(fmi3GetShiftFraction, fmi3UInt64, fmi3UInt64)
NO_CLOCK_2(fmi3SetShiftFraction, const fmi3UInt64, const fmi3UInt64)
NO_CLOCK_2(fmi3SetIntervalFraction, const fmi3UInt64, const fmi3UInt64)

EXPORT fmi3Status FMI3(fmi3GetIntervalFraction)(fmi3Instance instance,
                                                const fmi3ValueReference vr[], size_t n,
                                                fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                                fmi3IntervalQualifier qualifiers[]) {
  REQUIRE(ANY);
  (void)vr;
  (void)counters;
  (void)resolutions;
  (void)qualifiers;
  if (n == 0) {
    return fmi3OK;
  }
  REFUSE("the model has no clocks.");
}

EXPORT fmi3Status FMI3(fmi3GetNumberOfVariableDependencies)(fmi3Instance instance,
                                                            fmi3ValueReference reference,
                                                            size_t *n) {
  REQUIRE(ANY);
  (void)reference;
  (void)n;
  REFUSE("the dependencies are those of modelDescription.xml.");
}

EXPORT fmi3Status FMI3(fmi3GetVariableDependencies)(fmi3Instance instance,
                                                    fmi3ValueReference dependent,
                                                    size_t elements[],
                                                    fmi3ValueReference independents[],
                                                    size_t of[], fmi3DependencyKind kinds[],
                                                    size_t n) {
  REQUIRE(ANY);
  (void)dependent;
  (void)elements;
  (void)independents;
  (void)of;
  (void)kinds;
  (void)n;
  REFUSE("the dependencies are those of modelDescription.xml.");
}

EXPORT fmi3Status FMI3(fmi3GetFMUState)(fmi3Instance instance, fmi3FMUState *state) {
  REQUIRE(ANY);
  return (fmi3Status)mech_save(c, __func__, state);
}

EXPORT fmi3Status FMI3(fmi3SetFMUState)(fmi3Instance instance, fmi3FMUState state) {
  REQUIRE(ANY);
  return (fmi3Status)mech_restore(c, __func__, state);
}

EXPORT fmi3Status FMI3(fmi3FreeFMUState)(fmi3Instance instance, fmi3FMUState *state) {
  REQUIRE(ANY);
  return (fmi3Status)mech_discard(c, __func__, state);
}

EXPORT fmi3Status FMI3(fmi3SerializedFMUStateSize)(fmi3Instance instance, fmi3FMUState state,
                                                   size_t *size) {
  REQUIRE(ANY);
  REQUIRE_POINTER(state);
  REQUIRE_POINTER(size);
  *size = mech_saved_size();
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3SerializeFMUState)(fmi3Instance instance, fmi3FMUState state,
                                              fmi3Byte bytes[], size_t size) {
  REQUIRE(ANY);
  return (fmi3Status)mech_serialize(c, __func__, state, bytes, size);
}

EXPORT fmi3Status FMI3(fmi3DeserializeFMUState)(fmi3Instance instance, const fmi3Byte bytes[],
                                                size_t size, fmi3FMUState *state) {
  REQUIRE(ANY);
  return (fmi3Status)mech_deserialize(c, __func__, bytes, size, state);
}

EXPORT fmi3Status FMI3(fmi3GetDirectionalDerivative)(
    fmi3Instance instance, const fmi3ValueReference unknown[], size_t unknowns,
    const fmi3ValueReference known[], size_t knowns, const fmi3Float64 seed[], size_t seeds,
    fmi3Float64 sensitivity[], size_t sensitivities) {
  REQUIRE(MECH_INITIALIZATION | MECH_EVENT | MECH_CONTINUOUS | MECH_STEPPING | MECH_TERMINATED);
  return (fmi3Status)mech_directional(c, __func__, unknown, unknowns, known, knowns, seed, seeds,
                                      sensitivity, sensitivities);
}

EXPORT fmi3Status FMI3(fmi3GetAdjointDerivative)(
    fmi3Instance instance, const fmi3ValueReference unknown[], size_t unknowns,
    const fmi3ValueReference known[], size_t knowns, const fmi3Float64 seed[], size_t seeds,
    fmi3Float64 sensitivity[], size_t sensitivities) {
  REQUIRE(ANY);
  (void)unknown;
  (void)unknowns;
  (void)known;
  (void)knowns;
  (void)seed;
  (void)seeds;
  (void)sensitivity;
  (void)sensitivities;
  REFUSE("directional derivatives are offered, adjoint ones are not.");
}

EXPORT fmi3Status FMI3(fmi3EnterConfigurationMode)(fmi3Instance instance) {
  REQUIRE(ANY);
  REFUSE("the model has no structural parameters.");
}

EXPORT fmi3Status FMI3(fmi3ExitConfigurationMode)(fmi3Instance instance) {
  REQUIRE(ANY);
  REFUSE("the model has no structural parameters.");
}

EXPORT fmi3Status FMI3(fmi3EvaluateDiscreteStates)(fmi3Instance instance) {
  REQUIRE(MECH_INITIALIZATION | MECH_EVENT);
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3UpdateDiscreteStates)(fmi3Instance instance, fmi3Boolean *needed,
                                                 fmi3Boolean *terminate, fmi3Boolean *nominals,
                                                 fmi3Boolean *values, fmi3Boolean *next,
                                                 fmi3Float64 *nextTime) {
  int changed = 0;
  mech_status status;
  REQUIRE_KIND(0, MECH_EVENT);
  REQUIRE_POINTER(needed);
  REQUIRE_POINTER(terminate);
  REQUIRE_POINTER(nominals);
  REQUIRE_POINTER(values);
  REQUIRE_POINTER(next);
  REQUIRE_POINTER(nextTime);
  status = mech_update(c, &changed);
  *needed = false;
  *terminate = c->s.terminate != 0;
  *nominals = false;
  *values = changed != 0;
  *next = mech_next_jump(c) < HUGE_VAL;
  *nextTime = *next ? mech_next_jump(c) : 0;
  return (fmi3Status)status;
}

/* Model Exchange. */

EXPORT fmi3Status FMI3(fmi3EnterContinuousTimeMode)(fmi3Instance instance) {
  mech_status status;
  REQUIRE_KIND(0, MECH_EVENT);
  status = mech_begin_continuous(c);
  if (status == MECH_OK) {
    c->s.mode = MECH_CONTINUOUS;
  }
  return (fmi3Status)status;
}

EXPORT fmi3Status FMI3(fmi3CompletedIntegratorStep)(fmi3Instance instance,
                                                    fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                                    fmi3Boolean *enterEventMode,
                                                    fmi3Boolean *terminateSimulation) {
  int needed = 0;
  mech_status status;
  REQUIRE_KIND(0, MECH_CONTINUOUS);
  (void)noSetFMUStatePriorToCurrentPoint;
  REQUIRE_POINTER(enterEventMode);
  REQUIRE_POINTER(terminateSimulation);
  status = mech_step_completed(c, &needed);
  *enterEventMode = needed != 0;
  *terminateSimulation = c->s.terminate != 0;
  return (fmi3Status)status;
}

EXPORT fmi3Status FMI3(fmi3SetTime)(fmi3Instance instance, fmi3Float64 t) {
  REQUIRE_KIND(0, MECH_EVENT | MECH_CONTINUOUS);
  return (fmi3Status)mech_set_time(c, __func__, t);
}

EXPORT fmi3Status FMI3(fmi3SetContinuousStates)(fmi3Instance instance, const fmi3Float64 x[],
                                                size_t n) {
  REQUIRE_KIND(0, MECH_CONTINUOUS);
  return (fmi3Status)mech_set_states(c, __func__, x, n);
}

EXPORT fmi3Status FMI3(fmi3GetContinuousStateDerivatives)(fmi3Instance instance, fmi3Float64 dx[],
                                                          size_t n) {
  REQUIRE_KIND(0, READABLE);
  return (fmi3Status)mech_get_derivatives(c, __func__, dx, n);
}

EXPORT fmi3Status FMI3(fmi3GetEventIndicators)(fmi3Instance instance, fmi3Float64 g[], size_t n) {
  REQUIRE_KIND(0, READABLE);
  return (fmi3Status)mech_get_indicators(c, __func__, g, n);
}

EXPORT fmi3Status FMI3(fmi3GetContinuousStates)(fmi3Instance instance, fmi3Float64 x[], size_t n) {
  REQUIRE_KIND(0, READABLE);
  return (fmi3Status)mech_get_states(c, __func__, x, n);
}

EXPORT fmi3Status FMI3(fmi3GetNominalsOfContinuousStates)(fmi3Instance instance, fmi3Float64 x[],
                                                          size_t n) {
  size_t i;
  REQUIRE_KIND(0, ANY);
  if (n != MODEL_NX || (n > 0 && x == NULL)) {
    return (fmi3Status)mech_say(c, MECH_FAILED, "%s: the model has %d states.", __func__, MODEL_NX);
  }
  for (i = 0; i < n; i++) {
    x[i] = 1;
  }
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3GetNumberOfEventIndicators)(fmi3Instance instance, size_t *n) {
  REQUIRE_KIND(0, ANY);
  REQUIRE_POINTER(n);
  *n = MODEL_NG;
  return fmi3OK;
}

EXPORT fmi3Status FMI3(fmi3GetNumberOfContinuousStates)(fmi3Instance instance, size_t *n) {
  REQUIRE_KIND(0, ANY);
  REQUIRE_POINTER(n);
  *n = MODEL_NX;
  return fmi3OK;
}

/* Co-Simulation. */

EXPORT fmi3Status FMI3(fmi3EnterStepMode)(fmi3Instance instance) {
  REQUIRE(ANY);
  REFUSE("events are handled inside a step; there is no event mode to leave.");
}

EXPORT fmi3Status FMI3(fmi3GetOutputDerivatives)(fmi3Instance instance,
                                                 const fmi3ValueReference vr[], size_t n,
                                                 const fmi3Int32 orders[], fmi3Float64 values[],
                                                 size_t count) {
  REQUIRE_KIND(1, READABLE);
  (void)vr;
  (void)orders;
  (void)values;
  if (n == 0 && count == 0) {
    return fmi3OK;
  }
  REFUSE("outputs have no derivatives here.");
}

EXPORT fmi3Status FMI3(fmi3DoStep)(fmi3Instance instance, fmi3Float64 t, fmi3Float64 size,
                                   fmi3Boolean noSetFMUStatePriorToCurrentPoint,
                                   fmi3Boolean *eventHandlingNeeded,
                                   fmi3Boolean *terminateSimulation, fmi3Boolean *earlyReturn,
                                   fmi3Float64 *lastSuccessfulTime) {
  mech_status status;
  REQUIRE_KIND(1, MECH_STEPPING);
  (void)noSetFMUStatePriorToCurrentPoint;
  REQUIRE_POINTER(eventHandlingNeeded);
  REQUIRE_POINTER(terminateSimulation);
  REQUIRE_POINTER(earlyReturn);
  REQUIRE_POINTER(lastSuccessfulTime);
  if (!(size > 0)) {
    REFUSE("the step size is not positive.");
  }
  status = mech_do_step(c, __func__, t, size);
  *eventHandlingNeeded = false;
  *terminateSimulation = c->s.terminate != 0;
  *earlyReturn = false;
  *lastSuccessfulTime = c->s.t;
  return status == MECH_DISCARD && c->s.terminate ? fmi3OK : (fmi3Status)status;
}

EXPORT fmi3Status FMI3(fmi3ActivateModelPartition)(fmi3Instance instance,
                                                   fmi3ValueReference clock, fmi3Float64 t) {
  REQUIRE(ANY);
  (void)clock;
  (void)t;
  REFUSE("the model has no Scheduled Execution.");
}
