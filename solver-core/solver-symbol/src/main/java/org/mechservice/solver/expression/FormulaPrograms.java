package org.mechservice.solver.expression;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.GivenFunction;
import org.mechservice.solver.symbol.MathFunction;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.ReverseDifferentiation;
import org.mechservice.solver.symbol.Scalar;

/**
 * Derives programs from formulas: their values and their derivatives by the same rules as generated
 * code. Each instance derives one program; its first outputs are the values.
 *
 * <p>Inputs of the programs: leaf i is input 4 i, its rate along a trajectory 4 i + 1, its second
 * rate 4 i + 2, and its part of a direction 4 i + 3.
 */
final class FormulaPrograms {
  /** Inputs of a leaf. */
  static final int INPUTS = 4;

  static final int RATE = 1;
  static final int SECOND_RATE = 2;
  static final int DIRECTION = 3;

  /**
   * Derivatives of results by leaves, without those that are 0.
   *
   * @param program whose outputs they are, behind the values
   * @param leaves the leaf of each
   * @param ends for each result, the end of its derivatives
   */
  record ByLeaves(Program program, List<Integer> leaves, List<Integer> ends) {}

  private final Program program = new Program();
  private final Expressions e = program.expressions();
  private final Map<Expression, Scalar> leaves = new LinkedHashMap<>();
  private final List<Scalar> results;

  FormulaPrograms(List<Expression> formulas) {
    this(formulas, false);
  }

  /**
   * @param whole whether calls, powers and squares stay what they are in the formulas, as a search
   *     of the places where these change their form needs them, and not to be differentiated
   */
  FormulaPrograms(List<Expression> formulas, boolean whole) {
    OfLeaves scalars = whole ? new OfWholeCalls() : new OfLeaves();
    results = formulas.stream().map(scalars::scalar).toList();
    program.section("values", "value");
    for (int i = 0; i < results.size(); i++) {
      program.output(i, results.get(i));
    }
  }

  /** Leaves are inputs, in the order in which they come up; tables are one node. */
  private class OfLeaves extends Formulas {
    private final Map<PointFunction, GivenFunction> tables = new HashMap<>();

    OfLeaves() {
      super(e);
    }

    @Override
    protected Scalar input(Expression leaf) {
      return leaf(leaf);
    }

    @Override
    protected Scalar leaf(Expression leaf) {
      return leaves.computeIfAbsent(leaf, one -> e.input(INPUTS * leaves.size()));
    }

    @Override
    protected Scalar table(PointFunction table, List<Scalar> arguments) {
      return e.given(tables.computeIfAbsent(table, PointFunction::function), arguments);
    }
  }

  /** Calls are nodes of their own, also those that are formulas of others. */
  private final class OfWholeCalls extends OfLeaves {
    @Override
    protected Scalar call(MathFunction function, List<Scalar> arguments) {
      return function.isComposed() ? super.call(function, arguments) : e.whole(function, arguments);
    }

    @Override
    protected Scalar power(Scalar base, Scalar exponent) {
      return exponent.isConstant() && exponent.value() == 2
          ? base.squared()
          : e.whole(MathFunction.POWER, List.of(base, exponent));
    }
  }

  /** Returns the values of the formulas. */
  List<Scalar> results() {
    return results;
  }

  /** Returns what a leaf is in the program. */
  Scalar leaf(Expression leaf) {
    return Objects.requireNonNull(leaves.get(leaf));
  }

  /** Returns the leaves of the formulas. */
  List<Expression> leaves() {
    return List.copyOf(leaves.keySet());
  }

  /** Returns the program of the values alone. */
  Program values() {
    return program;
  }

  /** Returns what changes with the inputs of a kind, in the direction of those of another. */
  private Map<Scalar, Scalar> directions(int kind, int direction) {
    Map<Scalar, Scalar> directions = new HashMap<>();
    for (int i = 0; i < leaves.size(); i++) {
      directions.put(e.input(INPUTS * i + kind), e.input(INPUTS * i + direction));
    }
    return directions;
  }

  /** Returns the program that adds rates along a trajectory, and then second rates. */
  Program rates() {
    Map<Scalar, Scalar> directions = directions(0, RATE);
    directions.putAll(directions(RATE, SECOND_RATE));
    Differentiation rates = new Differentiation(e, directions);
    program.section("rates", "rate");
    int count = results.size();
    for (int i = 0; i < count; i++) {
      Scalar first = rates.of(results.get(i));
      program.output(count + i, first);
      program.output(2 * count + i, rates.of(first));
    }
    return program;
  }

  /** Returns the gradients of all results by the leaves. */
  ByLeaves gradients() {
    List<List<Scalar>> gradients = new ArrayList<>();
    for (Scalar result : results) {
      gradients.add(gradient(result));
    }
    return byLeaves(gradients);
  }

  /** Returns the change of the gradient of one result along the direction. */
  ByLeaves gradientChange(int result) {
    Differentiation change = new Differentiation(e, directions(0, DIRECTION));
    return byLeaves(List.of(gradient(results.get(result)).stream().map(change::of).toList()));
  }

  private List<Scalar> gradient(Scalar result) {
    ReverseDifferentiation derivative = new ReverseDifferentiation(e, Map.of(result, e.one()));
    return leaves.values().stream().map(derivative::by).toList();
  }

  private ByLeaves byLeaves(List<List<Scalar>> rows) {
    program.section("derivatives by leaves", "by");
    List<Integer> columns = new ArrayList<>();
    List<Integer> ends = new ArrayList<>();
    for (List<Scalar> row : rows) {
      for (int leaf = 0; leaf < leaves.size(); leaf++) {
        Scalar slope = row.get(leaf);
        if (!slope.isZero()) {
          program.output(results.size() + columns.size(), slope);
          columns.add(leaf);
        }
      }
      ends.add(columns.size());
    }
    return new ByLeaves(program, columns, ends);
  }
}
