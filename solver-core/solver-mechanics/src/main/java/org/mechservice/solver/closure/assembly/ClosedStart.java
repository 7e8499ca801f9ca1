package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;

/**
 * The start of a mechanism with loops: the closed position, the rank of the loop equations, and the
 * findings about them. Checking a model, choosing its formulation and running it need the same
 * start, which for a large mechanism takes longer than to read its file. Immutable.
 */
public final class ClosedStart {
  private final TreeGeometry tree;
  private final double time;
  private final double[] state;
  private final int rank;
  private final int positionRank;
  private final Optional<String> againstProjection;
  private final List<LoopFinding> findings;

  /**
   * Closes the loops of a mechanism.
   *
   * @param time start of the run, s
   */
  public ClosedStart(Mechanism mechanism, double time) {
    this.time = time;
    tree = new TreeGeometry(mechanism);
    state = new double[mechanism.stateCount()];
    mechanism.initialState(state);
    findings = new ArrayList<>(new Assembly(tree).assemble(time, state));
    if (isAssembled()) {
      RankAnalysis analysis = new RankAnalysis(tree, time, state);
      rank = analysis.rank();
      positionRank = analysis.positionRank();
      againstProjection = analysis.againstProjection();
      findings.addAll(analysis.findings(time));
    } else {
      rank = 0;
      positionRank = 0;
      againstProjection = Optional.empty();
    }
  }

  /**
   * Takes what {@link #found} gave for the same mechanism; nothing is computed.
   *
   * @throws IllegalArgumentException if the state has another length
   */
  public ClosedStart(Mechanism mechanism, Found found) {
    if (found.state().size() != mechanism.stateCount()) {
      throw new IllegalArgumentException(
          "a start of "
              + found.state().size()
              + " states is not one of "
              + mechanism.stateCount()
              + " states");
    }
    time = found.time();
    tree = new TreeGeometry(mechanism);
    state = found.state().stream().mapToDouble(Double::doubleValue).toArray();
    findings = List.copyOf(found.findings());
    rank = found.rank();
    positionRank = found.positionRank();
    againstProjection = found.againstProjection().stream().findFirst();
  }

  /**
   * The findings of closing the loops of a mechanism, in a form that travels with the model, so
   * that a large mechanism is closed once and not again in each run.
   *
   * @param time s
   * @param state [q; v; s], SI units
   * @param rank number of independent equations
   * @param positionRank number of those that restrict positions
   * @param againstProjection the reason against projection, if there is one
   * @param findings remarks for the user
   */
  public record Found(
      double time,
      List<Double> state,
      int rank,
      int positionRank,
      List<String> againstProjection,
      List<LoopFinding> findings) {
    public Found {
      state = List.copyOf(state);
      againstProjection = List.copyOf(againstProjection);
      findings = List.copyOf(findings);
    }
  }

  /** Returns the start as values that travel. */
  public Found found() {
    return new Found(
        time,
        Arrays.stream(state).boxed().toList(),
        rank,
        positionRank,
        againstProjection.stream().toList(),
        findings);
  }

  /** Returns whether the loops are closed; if not, {@link #findings()} says why. */
  public boolean isAssembled() {
    return findings.stream().allMatch(finding -> finding.kind().isWarning());
  }

  /** Returns the findings about the loops: corrections of the start, redundant equations. */
  public List<LoopFinding> findings() {
    return List.copyOf(findings);
  }

  /**
   * Returns the reason why no good choice of independent coordinates exists at the start, if there
   * is one. Penalty closure needs no such choice.
   */
  public Optional<String> againstProjection() {
    return againstProjection;
  }

  /** Returns the tree that is left when the loops are opened. */
  public TreeGeometry tree() {
    return tree;
  }

  /** Returns the number of independent equations of the loops; 0 if they are not closed. */
  public int rank() {
    return rank;
  }

  /**
   * Returns the number of independent equations that restrict positions; smaller than {@link #rank}
   * by the independent non-holonomic equations.
   */
  public int positionRank() {
    return positionRank;
  }

  /** Returns the time at which the loops are closed, s. */
  public double time() {
    return time;
  }

  /** Returns the assembled state [q; v; s]. */
  public double[] state() {
    return state.clone();
  }
}
