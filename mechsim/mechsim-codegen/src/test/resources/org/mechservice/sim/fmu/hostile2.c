/* Wrong calls: each must end in an error and leave the instance usable. */
#include "mech_fmi2.c"

#include <math.h>
#include <stdio.h>

static int messages, failures;

static void log_message(void *e, fmi2String name, fmi2Status status, fmi2String category,
                        fmi2String text, ...) {
  (void)e;
  (void)name;
  (void)category;
  messages += status >= fmi2Error && text != NULL;
}

#define EXPECT(call, expected)                                       \
  do {                                                               \
    int before = messages;                                           \
    fmi2Status status = (call);                                      \
    if (status != (expected)) {                                      \
      printf("line %d: %s gave %d\n", __LINE__, #call, (int)status); \
      failures++;                                                    \
    }                                                                \
    if ((expected) == fmi2Error && messages == before) {             \
      printf("line %d: %s said nothing\n", __LINE__, #call);         \
      failures++;                                                    \
    }                                                                \
  } while (0)

static fmi2CallbackFunctions callbacks = {log_message, NULL, NULL, NULL, NULL};

static void co_simulation(void) {
  fmi2Component c = fmi2Instantiate("c", fmi2CoSimulation, MODEL_TOKEN, NULL, &callbacks, 0, 1);
  fmi2ValueReference height = 1, rate = 3, parameter = 5, none = 4000000000u, zero = 0;
  double value = 2, nan = NAN, x[2];
  int integer = 0;
  fmi2FMUstate state = NULL, other = NULL;
  char bytes[1000];
  size_t size = 0;
  EXPECT(fmi2DoStep(c, 0, 0.1, 1), fmi2Error);
  EXPECT(fmi2ExitInitializationMode(c), fmi2Error);
  EXPECT(fmi2GetReal(c, &height, 1, &value), fmi2Error);
  EXPECT(fmi2SetReal(c, &parameter, 1, &nan), fmi2Error);
  EXPECT(fmi2SetReal(c, &none, 1, &value), fmi2Error);
  EXPECT(fmi2SetReal(c, &rate, 1, &value), fmi2Error);
  EXPECT(fmi2SetReal(c, &zero, 1, &value), fmi2Error);
  EXPECT(fmi2SetReal(c, NULL, 1, &value), fmi2Error);
  EXPECT(fmi2SetInteger(c, &height, 1, &integer), fmi2Error);
  EXPECT(fmi2SetupExperiment(c, 1, NAN, 0, 0, 0), fmi2Error);
  EXPECT(fmi2SetupExperiment(c, 1, -1, 0, 0, 0), fmi2Error);
  EXPECT(fmi2SetupExperiment(c, 0, 0, NAN, 0, 0), fmi2Error);
  EXPECT(fmi2SetupExperiment(c, 0, 0, 1, 1, 0), fmi2Error);
  EXPECT(fmi2SetupExperiment(c, 1, 1e-9, 0, 0, 0), fmi2OK);
  EXPECT(fmi2EnterInitializationMode(c), fmi2OK);
  EXPECT(fmi2SetReal(c, &height, 1, &value), fmi2OK);
  EXPECT(fmi2GetReal(c, &height, 1, &value), fmi2OK);
  EXPECT(fmi2ExitInitializationMode(c), fmi2OK);
  EXPECT(fmi2SetReal(c, &height, 1, &value), fmi2Error);
  EXPECT(fmi2DoStep(c, 0, NAN, 1), fmi2Error);
  EXPECT(fmi2DoStep(c, 0, -1, 1), fmi2Error);
  EXPECT(fmi2DoStep(c, 0, 0, 1), fmi2Error);
  EXPECT(fmi2DoStep(c, 0, INFINITY, 1), fmi2Error);
  EXPECT(fmi2DoStep(c, 7, 0.1, 1), fmi2Error);
  EXPECT(fmi2DoStep(c, 0, 1e-300, 1), fmi2OK);
  EXPECT(fmi2DoStep(c, 0, 1e-12, 1), fmi2OK);
  EXPECT(fmi2GetContinuousStates(c, x, 2), fmi2Error);
  EXPECT(fmi2SetTime(c, 0), fmi2Error);
  EXPECT(fmi2GetReal(c, &none, 1, &value), fmi2Error);
  EXPECT(fmi2GetReal(c, &height, 1, NULL), fmi2Error);
  EXPECT(fmi2SetFMUstate(c, NULL), fmi2Error);
  EXPECT(fmi2GetFMUstate(c, NULL), fmi2Error);
  EXPECT(fmi2GetFMUstate(c, &state), fmi2OK);
  EXPECT(fmi2SerializedFMUstateSize(c, state, &size), fmi2OK);
  EXPECT(fmi2SerializeFMUstate(c, state, bytes, 10), fmi2Error);
  EXPECT(fmi2DeSerializeFMUstate(c, bytes, 10, &other), fmi2Error);
  EXPECT(fmi2DeSerializeFMUstate(c, NULL, size, &other), fmi2Error);
  EXPECT(fmi2FreeFMUstate(c, &state), fmi2OK);
  EXPECT(fmi2FreeFMUstate(c, &state), fmi2OK);
  EXPECT(fmi2FreeFMUstate(c, NULL), fmi2OK);
  EXPECT(fmi2CancelStep(c), fmi2Error);
  EXPECT(fmi2DoStep(c, 1e-12, 1e9, 1), fmi2Error);
  EXPECT(fmi2Reset(c), fmi2OK);
  EXPECT(fmi2EnterInitializationMode(c), fmi2OK);
  EXPECT(fmi2ExitInitializationMode(c), fmi2OK);
  EXPECT(fmi2DoStep(c, 0, 1, 1), fmi2OK);
  EXPECT(fmi2Terminate(c), fmi2OK);
  EXPECT(fmi2DoStep(c, 1, 1, 1), fmi2Error);
  fmi2FreeInstance(c);
}

static void model_exchange(void) {
  fmi2Component c = fmi2Instantiate("m", fmi2ModelExchange, MODEL_TOKEN, NULL, &callbacks, 0, 1);
  fmi2EventInfo info;
  fmi2ValueReference parameter = 5, height = 1, rates[2] = {3, 4};
  double x[2] = {1, NAN}, g, value = 0.5, seed = 1, column[2];
  int event, end;
  EXPECT(fmi2EnterContinuousTimeMode(c), fmi2Error);
  EXPECT(fmi2EnterInitializationMode(c), fmi2OK);
  EXPECT(fmi2NewDiscreteStates(c, &info), fmi2Error);
  EXPECT(fmi2ExitInitializationMode(c), fmi2OK);
  EXPECT(fmi2NewDiscreteStates(c, NULL), fmi2Error);
  EXPECT(fmi2NewDiscreteStates(c, &info), fmi2OK);
  EXPECT(fmi2EnterContinuousTimeMode(c), fmi2OK);
  EXPECT(fmi2DoStep(c, 0, 1, 1), fmi2Error);
  EXPECT(fmi2SetContinuousStates(c, x, 2), fmi2Error);
  x[1] = 0;
  EXPECT(fmi2SetContinuousStates(c, x, 3), fmi2Error);
  EXPECT(fmi2SetContinuousStates(c, NULL, 2), fmi2Error);
  EXPECT(fmi2SetContinuousStates(c, x, 2), fmi2OK);
  EXPECT(fmi2SetTime(c, INFINITY), fmi2Error);
  EXPECT(fmi2GetEventIndicators(c, &g, 2), fmi2Error);
  EXPECT(fmi2GetEventIndicators(c, &g, 1), fmi2OK);
  EXPECT(fmi2GetDerivatives(c, x, 1), fmi2Error);
  EXPECT(fmi2SetReal(c, &parameter, 1, &value), fmi2Error);
  EXPECT(fmi2CompletedIntegratorStep(c, 1, NULL, NULL), fmi2Error);
  EXPECT(fmi2CompletedIntegratorStep(c, 1, &event, &end), fmi2OK);
  EXPECT(fmi2GetDirectionalDerivative(c, rates, 2, &height, 1, NULL, column), fmi2Error);
  EXPECT(fmi2GetDirectionalDerivative(c, &height, 1, rates, 1, &seed, column), fmi2Error);
  EXPECT(fmi2GetDirectionalDerivative(c, rates, 2, &height, 1, &seed, column), fmi2OK);
  x[0] = 1e300;
  EXPECT(fmi2SetContinuousStates(c, x, 2), fmi2OK);
  EXPECT(fmi2GetDerivatives(c, x, 2), fmi2OK);
  fmi2FreeInstance(c);
}

int main(void) {
  fmi2EventInfo info;
  double value;
  if (fmi2Instantiate("c", fmi2CoSimulation, "another", NULL, &callbacks, 0, 1) != NULL ||
      fmi2Instantiate("c", (fmi2Type)7, MODEL_TOKEN, NULL, &callbacks, 0, 1) != NULL ||
      fmi2Instantiate(NULL, fmi2CoSimulation, MODEL_TOKEN, NULL, &callbacks, 0, 1) != NULL ||
      fmi2Instantiate("c", fmi2CoSimulation, MODEL_TOKEN, NULL, NULL, 0, 1) != NULL ||
      messages != 3) {
    printf("an instance that should not be\n");
    failures++;
  }
  if (fmi2DoStep(NULL, 0, 1, 1) != fmi2Error || fmi2NewDiscreteStates(NULL, &info) != fmi2Error ||
      fmi2GetReal(NULL, NULL, 0, &value) != fmi2Error) {
    printf("no instance was taken for one\n");
    failures++;
  }
  fmi2FreeInstance(NULL);
  co_simulation();
  model_exchange();
  printf("%d failures\n", failures);
  return failures != 0;
}
