package org.mechservice.sim.emit.c;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.mechservice.sim.emit.plan.CodeForm;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;

/**
 * Programs of derivatives along a direction, which is given by the rates of the states, of time and
 * of the parameters, one behind the other. They are those of {@code sim.gradient}: an open chain's
 * x' is differentiated as it is; of closed loops M a + b + Jᵀλ and J a + c are at given a and λ, c
 * = γ + 2 Ω μ Φ' + Ω² Φ.
 */
final class CTangents {
  private final int states;
  private final int parameters;

  /**
   * @param states number of states
   * @param parameters number of parameters, inputs and loads that the programs read
   */
  CTangents(int states, int parameters) {
    this.states = states;
    this.parameters = parameters;
  }

  /**
   * Returns the derivative of a program's outputs, with its guards.
   *
   * @param seeds first input that is a rate
   */
  Program of(Program program, int seeds) {
    return along(program, outputs(program), seeds, true);
  }

  /**
   * Returns the derivative of M a + b + Jᵀλ, then of J a + c.
   *
   * @param given first input that is an acceleration; the multipliers follow
   * @param seeds first input that is a rate
   */
  Program ofLoops(CLoops loops, int velocities, int given, int seeds) {
    Program program = loops.equations();
    Expressions e = program.expressions();
    Map<Integer, Scalar> terms = outputs(program);
    int m = loops.rows();
    int n = velocities;
    Map<Integer, Scalar> sums = new TreeMap<>();
    for (int i = 0; i < n; i++) {
      Scalar sum = terms.getOrDefault(LoopTerms.biasAt(m, n) + i, e.zero());
      for (int j = 0; j < n; j++) {
        int at = LoopTerms.massAt(m, n) + Math.max(i, j) * n + Math.min(i, j);
        sum = sum.plus(terms.getOrDefault(at, e.zero()).times(e.input(given + j)));
      }
      for (int r = 0; r < m; r++) {
        Scalar element = terms.getOrDefault(LoopTerms.jacobianAt(m) + r * n + i, e.zero());
        sum = sum.plus(element.times(e.input(given + n + r)));
      }
      sums.put(i, sum);
    }
    double frequency = loops.penalty().frequency();
    double damping = 2 * frequency * loops.penalty().damping();
    for (int r = 0; r < m; r++) {
      Scalar sum = terms.getOrDefault(LoopTerms.offsetAt(m, n) + r, e.zero());
      for (int j = 0; j < n; j++) {
        Scalar element = terms.getOrDefault(LoopTerms.jacobianAt(m) + r * n + j, e.zero());
        sum = sum.plus(element.times(e.input(given + j)));
      }
      Scalar rate = terms.getOrDefault(m + r, e.zero());
      Scalar value = terms.getOrDefault(r, e.zero());
      sum = sum.plus(rate.times(damping)).plus(value.times(frequency * frequency));
      sums.put(n + r, sum);
    }
    return along(program, sums, seeds, false);
  }

  private static Map<Integer, Scalar> outputs(Program program) {
    Map<Integer, Scalar> outputs = new TreeMap<>();
    for (Program.Section section : program.sections()) {
      section.outputs().forEach(output -> outputs.put(output.index(), output.value()));
    }
    return outputs;
  }

  private Program along(
      Program program, Map<Integer, Scalar> outputs, int seeds, boolean isGuarded) {
    Expressions e = program.expressions();
    Map<Scalar, Scalar> rates = new HashMap<>();
    for (int i = 0; i < states; i++) {
      rates.put(e.input(i), e.input(seeds + i));
    }
    rates.put(e.input(Program.TIME), e.input(seeds + states));
    for (int k = 0; k < parameters; k++) {
      rates.put(e.input(Program.PARAMETER + k), e.input(seeds + states + 1 + k));
    }
    List<Program.Section> sections = new ArrayList<>();
    for (Program.Section section : program.sections()) {
      sections.add(
          new Program.Section(
              section.title(),
              section.subject(),
              section.firstNode(),
              new ArrayList<>(),
              isGuarded ? section.guards() : new ArrayList<>(),
              section.readsAnew()));
    }
    Program more = program.in(sections);
    Differentiation along = new Differentiation(e, rates);
    if (program.operationCount() >= CodeForm.LEAST_OPERATIONS) {
      along.sections(program, more);
    }
    more.section("Derivative along a direction.", "d");
    outputs.forEach((index, node) -> more.output(index, along.of(node)));
    return more;
  }
}
