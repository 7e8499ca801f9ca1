package org.mechservice.sim.fmu;

/** Value references of a model's variables: the layout of {@code mech_fmu.h}. */
record ValueReferences(
    int state, int derivative, int parameter, int input, int output, int indicator) {
  static final int TIME = 0;

  static ValueReferences of(FmuModel model) {
    int state = TIME + 1;
    int derivative = state + model.states().size();
    int parameter = derivative + model.states().size();
    int input = parameter + model.parameters().size();
    int output = input + model.inputs().size();
    return new ValueReferences(
        state, derivative, parameter, input, output, output + model.outputs().size());
  }
}
