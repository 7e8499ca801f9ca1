package org.mechservice.solver.symbol;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;

/**
 * First and second derivatives of a function of one or two arguments in doubles, from the slopes
 * that the catalogue gives. Workspace of one thread; nothing allocates after construction.
 */
public final class FunctionDerivatives {
  /** Places of the derivatives by a, by b, twice by a, by both and twice by b. */
  public static final int BY_A = 0;

  public static final int BY_B = 1;
  public static final int BY_AA = 2;
  public static final int BY_AB = 3;
  public static final int BY_BB = 4;
  private static final int COUNT = 5;

  private static final Map<MathFunction, Program> PROGRAMS = new ConcurrentHashMap<>();

  private final ProgramEvaluation evaluation;
  private final Scalar[] derivatives = new Scalar[COUNT];
  private final double[] arguments = new double[2];

  /** Makes a workspace for a function that formulas can call. */
  public FunctionDerivatives(MathFunction function) {
    Program program = PROGRAMS.computeIfAbsent(function, FunctionDerivatives::program);
    evaluation = new ProgramEvaluation(program);
    for (Program.Output output : program.sections().get(0).outputs()) {
      derivatives[output.index()] = output.value();
    }
  }

  private static Program program(MathFunction function) {
    Program program = new Program();
    program.section("derivatives", "f");
    Expressions e = program.expressions();
    List<Scalar> inputs = List.of(e.input(0), e.input(1)).subList(0, function.arity());
    Scalar call = function.call(inputs);
    Scalar byA = rate(call, inputs, 0);
    Scalar byB = rate(call, inputs, 1);
    program.output(BY_A, byA);
    program.output(BY_B, byB);
    program.output(BY_AA, rate(byA, inputs, 0));
    program.output(BY_AB, rate(byA, inputs, 1));
    program.output(BY_BB, rate(byB, inputs, 1));
    program.uses();
    return program;
  }

  private static Scalar rate(Scalar value, List<Scalar> inputs, int input) {
    Expressions e = value.expressions();
    return input < inputs.size()
        ? new Differentiation(e, Map.of(inputs.get(input), e.one())).of(value)
        : e.zero();
  }

  /** Evaluates the derivatives; of one argument the second is ignored. */
  public void evaluate(double a, double b) {
    arguments[0] = a;
    arguments[1] = b;
    evaluation.evaluate(0, arguments);
  }

  /**
   * Returns a derivative after {@link #evaluate}; not finite where it does not exist.
   *
   * @param which {@link #BY_A} to {@link #BY_BB}
   */
  public double value(int which) {
    return evaluation.valueOf(derivatives[which]);
  }
}
