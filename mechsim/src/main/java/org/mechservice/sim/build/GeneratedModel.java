package org.mechservice.sim.build;

import java.util.List;

/**
 * A model as readable Java source.
 *
 * @param className fully qualified name of the class
 * @param source its formatted source
 * @param formulation formulation its equations are written in
 * @param formulationReason why this formulation
 * @param operations additions, multiplications and divisions of one evaluation of the derivative
 * @param leftOut what the scene does not need
 * @param modelName the model's name in its file
 */
public record GeneratedModel(
    String className,
    String source,
    String formulation,
    String formulationReason,
    int operations,
    List<Omission> leftOut,
    String modelName) {
  public GeneratedModel {
    leftOut = List.copyOf(leftOut);
  }
}
