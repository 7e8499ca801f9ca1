package org.mechservice.sim.model;

import java.util.List;
import java.util.Set;
import org.mechservice.solver.api.result.ColumnGroup;

/**
 * Facts about a generated model. They are small, whereas its plan holds every operation.
 *
 * @param className fully qualified name of the class to be instantiated
 * @param sourceName fully qualified name of the class that has the equations
 * @param modelName the model's name in its file
 * @param formulation formulation its equations are written in
 * @param formulationReason why this formulation
 * @param operations additions, multiplications and divisions of one evaluation of the derivative
 * @param code how the model computes, and how many operations each part of it takes
 * @param dataColumns groups of columns that the data compute, with or without code beside them
 * @param leftOut what the scene does not need
 * @param fromData what is computed from the data beside the code; nothing of a model that is data
 */
public record GeneratedFacts(
    String className,
    String sourceName,
    String modelName,
    String formulation,
    String formulationReason,
    int operations,
    String code,
    Set<ColumnGroup> dataColumns,
    List<Omission> leftOut,
    List<Omission> fromData) {

  public GeneratedFacts {
    dataColumns = Set.copyOf(dataColumns);
    leftOut = List.copyOf(leftOut);
    fromData = List.copyOf(fromData);
  }
}
