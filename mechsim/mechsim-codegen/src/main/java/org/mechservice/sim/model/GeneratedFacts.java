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
 * @param formulation formulation of its equations
 * @param formulationReason reason for the formulation
 * @param operations additions, multiplications and divisions of one evaluation of the derivative
 * @param code description of the code, with the number of operations of each part
 * @param dataColumns groups of columns computed from data
 * @param leftOut parts that the scene does not need
 * @param fromData parts computed from data in addition to the code; empty for a data-driven model
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
