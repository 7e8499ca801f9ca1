/* Wrong calls of FMI 3.0: each must end in an error and leave the instance usable. */
#include "mech_fmi3.c"

#include <math.h>
#include <stdio.h>

static int messages, failures;

static void log_message(fmi3InstanceEnvironment e, fmi3Status status, fmi3String category,
                        fmi3String text) {
  (void)e;
  (void)category;
  messages += status >= fmi3Error && text != NULL;
}

#define EXPECT(call, expected)                                       \
  do {                                                               \
    int before = messages;                                           \
    fmi3Status status = (call);                                      \
    if (status != (expected)) {                                      \
      printf("line %d: %s gave %d\n", __LINE__, #call, (int)status); \
      failures++;                                                    \
    }                                                                \
    if ((expected) == fmi3Error && messages == before) {             \
      printf("line %d: %s said nothing\n", __LINE__, #call);         \
      failures++;                                                    \
    }                                                                \
  } while (0)

#define STEP(t, h) \
  fmi3DoStep(c, t, h, true, &handling, &end, &early, &reached)

static fmi3Instance co_simulated(fmi3Boolean events) {
  return fmi3InstantiateCoSimulation("c", MODEL_TOKEN, NULL, false, true, events, false, NULL, 0,
                                     NULL, log_message, NULL);
}

static void co_simulation(void) {
  fmi3Instance c = co_simulated(false);
  fmi3ValueReference height = 1, rate = 3, parameter = 5, none = 4000000000u, zero = 0;
  fmi3Boolean handling, end, early, flag = false;
  fmi3Float64 value = 2, nan = NAN, x[2], reached;
  fmi3Int32 integer = 0, order = 1;
  fmi3FMUState state = NULL, other = NULL;
  fmi3Byte bytes[1000];
  size_t size = 0;
  EXPECT(STEP(0, 0.1), fmi3Error);
  EXPECT(fmi3ExitInitializationMode(c), fmi3Error);
  EXPECT(fmi3GetFloat64(c, &height, 1, &value, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, &parameter, 1, &nan, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, &none, 1, &value, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, &rate, 1, &value, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, &zero, 1, &value, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, NULL, 1, &value, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, &height, 1, &value, 2), fmi3Error);
  EXPECT(fmi3SetInt32(c, &height, 1, &integer, 1), fmi3Error);
  EXPECT(fmi3SetBoolean(c, &height, 1, &flag, 1), fmi3Error);
  EXPECT(fmi3EnterInitializationMode(c, true, NAN, 0, false, 0), fmi3Error);
  EXPECT(fmi3EnterInitializationMode(c, true, -1, 0, false, 0), fmi3Error);
  EXPECT(fmi3EnterInitializationMode(c, false, 0, NAN, false, 0), fmi3Error);
  EXPECT(fmi3EnterInitializationMode(c, false, 0, 1, true, 0), fmi3Error);
  EXPECT(fmi3EnterInitializationMode(c, true, 1e-9, 0, false, 0), fmi3OK);
  EXPECT(fmi3SetFloat64(c, &height, 1, &value, 1), fmi3OK);
  EXPECT(fmi3GetFloat64(c, &height, 1, &value, 1), fmi3OK);
  EXPECT(fmi3ExitInitializationMode(c), fmi3OK);
  EXPECT(fmi3SetFloat64(c, &height, 1, &value, 1), fmi3Error);
  EXPECT(STEP(0, NAN), fmi3Error);
  EXPECT(STEP(0, -1), fmi3Error);
  EXPECT(STEP(0, 0), fmi3Error);
  EXPECT(STEP(0, INFINITY), fmi3Error);
  EXPECT(STEP(7, 0.1), fmi3Error);
  EXPECT(fmi3DoStep(c, 0, 0.1, true, NULL, &end, &early, &reached), fmi3Error);
  EXPECT(STEP(0, 1e-300), fmi3OK);
  EXPECT(STEP(0, 1e-12), fmi3OK);
  EXPECT(fmi3GetContinuousStates(c, x, 2), fmi3Error);
  EXPECT(fmi3SetTime(c, 0), fmi3Error);
  EXPECT(fmi3EnterEventMode(c), fmi3Error);
  EXPECT(fmi3EnterStepMode(c), fmi3Error);
  EXPECT(fmi3EnterConfigurationMode(c), fmi3Error);
  EXPECT(fmi3GetOutputDerivatives(c, &height, 1, &order, &value, 1), fmi3Error);
  EXPECT(fmi3ActivateModelPartition(c, 1, 0), fmi3Error);
  EXPECT(fmi3GetFloat64(c, &none, 1, &value, 1), fmi3Error);
  EXPECT(fmi3GetFloat64(c, &height, 1, NULL, 1), fmi3Error);
  EXPECT(fmi3SetFMUState(c, NULL), fmi3Error);
  EXPECT(fmi3GetFMUState(c, NULL), fmi3Error);
  EXPECT(fmi3GetFMUState(c, &state), fmi3OK);
  EXPECT(fmi3SerializedFMUStateSize(c, state, &size), fmi3OK);
  EXPECT(fmi3SerializedFMUStateSize(c, state, NULL), fmi3Error);
  EXPECT(fmi3SerializeFMUState(c, state, bytes, 10), fmi3Error);
  EXPECT(fmi3DeserializeFMUState(c, bytes, 10, &other), fmi3Error);
  EXPECT(fmi3DeserializeFMUState(c, NULL, size, &other), fmi3Error);
  EXPECT(fmi3FreeFMUState(c, &state), fmi3OK);
  EXPECT(fmi3FreeFMUState(c, &state), fmi3OK);
  EXPECT(fmi3FreeFMUState(c, NULL), fmi3OK);
  EXPECT(STEP(1e-12, 1e9), fmi3Error);
  EXPECT(fmi3Reset(c), fmi3OK);
  EXPECT(fmi3EnterInitializationMode(c, false, 0, 0, false, 0), fmi3OK);
  EXPECT(fmi3ExitInitializationMode(c), fmi3OK);
  EXPECT(STEP(0, 1), fmi3OK);
  EXPECT(fmi3Terminate(c), fmi3OK);
  EXPECT(STEP(1, 1), fmi3Error);
  fmi3FreeInstance(c);
}

static void model_exchange(void) {
  fmi3Instance c = fmi3InstantiateModelExchange("m", MODEL_TOKEN, NULL, false, true, NULL, log_message);
  fmi3Boolean needed, end, nominals, values, next, event, early, handling;
  fmi3ValueReference parameter = 5, height = 1, rates[2] = {3, 4};
  fmi3Float64 x[2] = {1, NAN}, g, value = 0.5, seed = 1, column[2], time, reached;
  size_t count;
  EXPECT(fmi3EnterContinuousTimeMode(c), fmi3Error);
  EXPECT(fmi3EnterInitializationMode(c, false, 0, 0, false, 0), fmi3OK);
  EXPECT(fmi3UpdateDiscreteStates(c, &needed, &end, &nominals, &values, &next, &time), fmi3Error);
  EXPECT(fmi3ExitInitializationMode(c), fmi3OK);
  EXPECT(fmi3UpdateDiscreteStates(c, NULL, &end, &nominals, &values, &next, &time), fmi3Error);
  EXPECT(fmi3UpdateDiscreteStates(c, &needed, &end, &nominals, &values, &next, &time), fmi3OK);
  EXPECT(fmi3EnterContinuousTimeMode(c), fmi3OK);
  EXPECT(STEP(0, 1), fmi3Error);
  EXPECT(fmi3SetContinuousStates(c, x, 2), fmi3Error);
  x[1] = 0;
  EXPECT(fmi3SetContinuousStates(c, x, 3), fmi3Error);
  EXPECT(fmi3SetContinuousStates(c, NULL, 2), fmi3Error);
  EXPECT(fmi3SetContinuousStates(c, x, 2), fmi3OK);
  EXPECT(fmi3SetTime(c, INFINITY), fmi3Error);
  EXPECT(fmi3GetNumberOfContinuousStates(c, NULL), fmi3Error);
  EXPECT(fmi3GetNumberOfContinuousStates(c, &count), fmi3OK);
  EXPECT(fmi3GetNominalsOfContinuousStates(c, x, 7), fmi3Error);
  EXPECT(fmi3GetEventIndicators(c, &g, 2), fmi3Error);
  EXPECT(fmi3GetEventIndicators(c, &g, 1), fmi3OK);
  EXPECT(fmi3GetContinuousStateDerivatives(c, x, 1), fmi3Error);
  EXPECT(fmi3SetFloat64(c, &parameter, 1, &value, 1), fmi3Error);
  EXPECT(fmi3CompletedIntegratorStep(c, true, NULL, &end), fmi3Error);
  EXPECT(fmi3CompletedIntegratorStep(c, true, &event, &end), fmi3OK);
  EXPECT(fmi3GetDirectionalDerivative(c, rates, 2, &height, 1, NULL, 1, column, 2), fmi3Error);
  EXPECT(fmi3GetDirectionalDerivative(c, rates, 2, &height, 1, &seed, 1, column, 1), fmi3Error);
  EXPECT(fmi3GetDirectionalDerivative(c, &height, 1, rates, 1, &seed, 1, column, 1), fmi3Error);
  EXPECT(fmi3GetDirectionalDerivative(c, rates, 2, &height, 1, &seed, 1, column, 2), fmi3OK);
  EXPECT(fmi3GetAdjointDerivative(c, rates, 2, &height, 1, &seed, 2, column, 1), fmi3Error);
  x[0] = 1e300;
  x[1] = 0;
  EXPECT(fmi3SetContinuousStates(c, x, 2), fmi3OK);
  EXPECT(fmi3GetContinuousStateDerivatives(c, x, 2), fmi3OK);
  fmi3FreeInstance(c);
}

int main(void) {
  fmi3Boolean needed, end, nominals, values, next;
  fmi3Float64 value, time;
  if (fmi3InstantiateModelExchange("c", "another", NULL, false, true, NULL, log_message) != NULL ||
      fmi3InstantiateModelExchange(NULL, MODEL_TOKEN, NULL, false, true, NULL, log_message) != NULL ||
      fmi3InstantiateScheduledExecution("c", MODEL_TOKEN, NULL, false, true, NULL, log_message, NULL,
                                        NULL, NULL) != NULL ||
      co_simulated(true) != NULL || messages != 4) {
    printf("an instance that should not be\n");
    failures++;
  }
  if (fmi3UpdateDiscreteStates(NULL, &needed, &end, &nominals, &values, &next, &time) != fmi3Error ||
      fmi3GetFloat64(NULL, NULL, 0, &value, 0) != fmi3Error) {
    printf("no instance was taken for one\n");
    failures++;
  }
  fmi3FreeInstance(NULL);
  co_simulation();
  model_exchange();
  printf("%d failures\n", failures);
  return failures != 0;
}
