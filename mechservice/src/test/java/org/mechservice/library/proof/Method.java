package org.mechservice.library.proof;

import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;

/**
 * How a scene runs.
 *
 * @param formulation formulation of the equations
 * @param integrator integrator
 * @param relative relative tolerance
 * @param absolute absolute tolerance, SI
 * @param maxStep largest step, s
 * @param compact whether the model is data instead of generated code
 */
record Method(
    String formulation,
    String integrator,
    double relative,
    double absolute,
    OptionalDouble maxStep,
    boolean compact) {
  private static final List<List<String>> KINDS =
      List.of(
          List.of("auto", "auto"),
          List.of("DTR", "ode113"),
          List.of("DTR", "DE"),
          List.of("DTR", "ode15s"),
          List.of("DTR", "switching"),
          List.of("DSR", "ode113"),
          List.of("DSR", "ode15s"),
          List.of("RR", "ode15sR"),
          List.of("RR-JF", "ode15sR"));

  /** Returns any method with a relative tolerance between 1e-3 and 1e-12, code or data. */
  static Method any(Random random) {
    return any(random, 1e-3);
  }

  /** Returns any method with a relative tolerance between a loosest one and 1e-12. */
  static Method any(Random random, double loosest) {
    List<String> kind = KINDS.get(random.nextInt(KINDS.size()));
    double relative = Spread.log(random, 1e-12, loosest);
    double absolute = Math.max(1e-13, relative * Spread.log(random, 1e-2, 1));
    boolean compact = random.nextInt(10) < 3;
    return new Method(
        kind.get(0), kind.get(1), relative, absolute, OptionalDouble.empty(), compact);
  }

  /** Returns the method as it is for closed loops, which DTR does not take. */
  Method forLoops() {
    return formulation.equals("DTR")
        ? new Method("DSR", integrator, relative, absolute, maxStep, compact)
        : this;
  }

  /** Returns the method with a largest step. */
  Method within(double step) {
    return new Method(
        formulation, integrator, relative, absolute, OptionalDouble.of(step), compact);
  }

  /** Returns the method with other tolerances. */
  Method at(double relativeTolerance, double absoluteTolerance) {
    return new Method(
        formulation, integrator, relativeTolerance, absoluteTolerance, maxStep, compact);
  }

  /** Returns the error that one step may leave in a state. */
  double allowed(double state) {
    return relative * Math.abs(state) + absolute;
  }

  /** Returns the elements of a model file. */
  String text() {
    return "<integrator name='"
        + integrator
        + "' relTol='"
        + relative
        + "' absTol='"
        + absolute
        + "'"
        + (maxStep.isPresent() ? " maxStep='" + maxStep.getAsDouble() + "'" : "")
        + "/><formulation name='"
        + formulation
        + "'/>";
  }

  @Override
  public String toString() {
    return formulation + "/" + integrator + " " + relative + (compact ? " data" : " code");
  }
}
