package org.mechservice.study.gradient;

import java.util.List;
import org.mechservice.sim.gradient.ModelFunctions;

/**
 * A parameter or start value by which results are differentiated.
 *
 * @param name of the parameter, or of the component of the start
 * @param unit of the values below
 * @param factor one unit in SI, for inputs of the code; 1 for the others
 * @param size typical size of the value in the direction's own measure, positive
 * @param input place among the inputs by which the functions are differentiated; −1 for none
 * @param step distance h of the models beside it; 0 for none
 * @param beside models at −2h, −h, h and 2h, of a parameter that is folded into the equations;
 *     empty for the others
 * @param start derivative of the start by it
 */
@SuppressWarnings("ArrayRecordComponent") // never compared
record Direction(
    String name,
    String unit,
    double factor,
    double size,
    int input,
    double step,
    List<ModelFunctions> beside,
    double[] start) {
  boolean isSettled() {
    return !beside.isEmpty();
  }
}
