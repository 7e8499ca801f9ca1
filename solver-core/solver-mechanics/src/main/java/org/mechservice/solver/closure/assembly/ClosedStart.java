package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
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
   * is one. Penalty closure needs no such choice (NUMERICS §3).
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
