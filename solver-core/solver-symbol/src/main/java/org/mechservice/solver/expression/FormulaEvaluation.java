package org.mechservice.solver.expression;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.symbol.ProgramEvaluation;

/**
 * Evaluates formulas: values, gradients by the leaves, derivatives along a trajectory. Workspace of
 * one thread; nothing allocates after construction but the first call of each method of
 * derivatives, which derives them.
 *
 * <p>Set the leaves, call {@link #values()} or {@link #derivatives()}, then read the results. A
 * result may be not finite; {@link #firstNotFinite()} finds it.
 */
public final class FormulaEvaluation {
  private final List<Expression> formulas;
  private final List<Expression> leaves;
  private final ProgramEvaluation ofValues;

  /** What each leaf gives, as {@link FormulaPrograms} tells. */
  private final double[] inputs;

  /** Values of the results, first and second rates. */
  private final double[] results;

  private Optional<ProgramEvaluation> ofRates = Optional.empty();
  private Optional<Slopes> gradients = Optional.empty();
  private final List<Optional<Slopes>> changes;

  /** Whether the values, and the gradients, are those of the leaves. */
  private boolean valuesAreKnown;

  private boolean gradientsAreKnown;

  /** Derivatives by the leaves, as they were last evaluated. */
  private static final class Slopes {
    private final int[] leaves;
    private final int[] ends;
    private final ProgramEvaluation evaluation;
    private final int results;
    private final double[] outputs;

    Slopes(FormulaPrograms.ByLeaves what, int results) {
      leaves = what.leaves().stream().mapToInt(Integer::intValue).toArray();
      ends = what.ends().stream().mapToInt(Integer::intValue).toArray();
      this.results = results;
      evaluation = new ProgramEvaluation(what.program());
      outputs = new double[results + leaves.length];
    }

    void evaluate(double[] inputs, double[] values) {
      evaluation.run(0, inputs, outputs);
      System.arraycopy(outputs, 0, values, 0, results);
    }

    /** Returns whether all derivatives are zero everywhere. */
    boolean areZero() {
      return leaves.length == 0;
    }

    void write(int row, double[] gradient) {
      Arrays.fill(gradient, 0);
      for (int i = row == 0 ? 0 : ends[row - 1]; i < ends[row]; i++) {
        gradient[leaves[i]] = outputs[results + i];
      }
    }
  }

  /**
   * Makes a workspace.
   *
   * @param formulas in the order of the results
   */
  public FormulaEvaluation(List<Expression> formulas) {
    this.formulas = List.copyOf(formulas);
    FormulaPrograms programs = new FormulaPrograms(formulas);
    ofValues = new ProgramEvaluation(programs.values());
    leaves = programs.leaves();
    inputs = new double[FormulaPrograms.INPUTS * leaves.size()];
    results = new double[3 * formulas.size()];
    changes = new ArrayList<>(Collections.nCopies(formulas.size(), Optional.empty()));
  }

  /** Returns the inputs of an evaluation: all leaves except constants, each once. */
  public List<Expression> leaves() {
    return leaves;
  }

  /** Returns the number of results. */
  public int resultCount() {
    return formulas.size();
  }

  /**
   * Sets a leaf, in SI units.
   *
   * @param leaf index in {@link #leaves()}
   */
  public void setLeaf(int leaf, double x) {
    inputs[FormulaPrograms.INPUTS * leaf] = x;
  }

  /**
   * Sets a leaf and its derivatives along the trajectory.
   *
   * @param leaf index in {@link #leaves()}
   * @param x value
   * @param first derivative by time
   * @param second second derivative by time; with the accelerations left out of it, {@link
   *     #secondRate} gives the velocity products alone
   */
  public void setLeaf(int leaf, double x, double first, double second) {
    setLeaf(leaf, x);
    inputs[FormulaPrograms.INPUTS * leaf + FormulaPrograms.RATE] = first;
    inputs[FormulaPrograms.INPUTS * leaf + FormulaPrograms.SECOND_RATE] = second;
  }

  /** Evaluates all results. */
  public void values() {
    ofValues.run(0, inputs, results);
    valuesAreKnown = true;
  }

  /** Evaluates all results; the methods below give their derivatives at these leaves. */
  public void derivatives() {
    valuesAreKnown = false;
    gradientsAreKnown = false;
  }

  /**
   * Evaluates first and second derivatives of all results along the trajectory, after {@link
   * #derivatives()}.
   */
  public void rates() {
    if (ofRates.isEmpty()) {
      ofRates = Optional.of(new ProgramEvaluation(new FormulaPrograms(formulas).rates()));
    }
    ofRates.get().run(0, inputs, results);
    valuesAreKnown = true;
  }

  /** Returns a result. */
  public double value(int index) {
    if (!valuesAreKnown) {
      values();
    }
    return results[index];
  }

  /** Returns a result's derivative along the trajectory after {@link #rates()}. */
  public double rate(int index) {
    return results[formulas.size() + index];
  }

  /** Returns a result's second derivative along the trajectory after {@link #rates()}. */
  public double secondRate(int index) {
    return results[2 * formulas.size() + index];
  }

  /**
   * Writes the gradient of a result by the leaves after {@link #derivatives()}.
   *
   * @param index the result
   * @param gradient one number per leaf; overwritten
   */
  public void gradient(int index, double[] gradient) {
    if (gradients.isEmpty()) {
      gradients =
          Optional.of(new Slopes(new FormulaPrograms(formulas).gradients(), formulas.size()));
    }
    if (!gradientsAreKnown) {
      gradients.get().evaluate(inputs, results);
      valuesAreKnown = true;
      gradientsAreKnown = true;
    }
    gradients.get().write(index, gradient);
  }

  /**
   * Writes the change of a result's gradient along a direction of the leaves, H d with the Hessian
   * H, after {@link #derivatives()}.
   *
   * @param index the result
   * @param direction d, one number per leaf; not modified
   * @param change H d, one number per leaf; overwritten
   */
  public void gradientChange(int index, double[] direction, double[] change) {
    if (changes.get(index).isEmpty()) {
      FormulaPrograms.ByLeaves derived = new FormulaPrograms(formulas).gradientChange(index);
      changes.set(index, Optional.of(new Slopes(derived, formulas.size())));
    }
    Slopes slopes = changes.get(index).get();
    if (!slopes.areZero()) {
      for (int leaf = 0; leaf < leaves.size(); leaf++) {
        inputs[FormulaPrograms.INPUTS * leaf + FormulaPrograms.DIRECTION] = direction[leaf];
      }
      slopes.evaluate(inputs, results);
    }
    slopes.write(0, change);
  }

  /** Returns the first result whose value is not finite, or −1. */
  public int firstNotFinite() {
    for (int i = 0; i < formulas.size(); i++) {
      if (!Double.isFinite(value(i))) {
        return i;
      }
    }
    return -1;
  }
}
