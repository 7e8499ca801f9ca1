package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.assembly.RankAnalysis;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * A mechanism with closed loops after assembly: its loops are closed at the start and the rank of
 * its loop equations is known. Models are made from it. Immutable, apart from generated code that
 * evaluates its equations.
 */
public final class ClosedMechanism {
  private final TreeGeometry tree;
  private final ModelDescription description;
  private final double startTime;
  private final double[] start;
  private final int rank;
  private final Optional<String> againstProjection;
  private final List<LoopFinding> findings = new ArrayList<>();

  private final Optional<LoopTerms> terms;

  /** For each velocity of the state, its joint among those that have states. */
  private final int[] jointOfVelocity;

  /**
   * Assembles a mechanism at the start of its run.
   *
   * @param formulation name of the formulation, for reports
   * @param defaults default settings of the model; assembly takes place at their start time
   */
  public ClosedMechanism(Mechanism mechanism, String formulation, RunSettings defaults) {
    tree = new TreeGeometry(mechanism);
    terms = Optional.empty();
    jointOfVelocity = new int[mechanism.velocityCount()];
    description = new ModelDescription(mechanism.name(), formulation, joints(mechanism), defaults);
    startTime = defaults.tStart();
    start = new double[mechanism.positionCount() + mechanism.velocityCount()];
    mechanism.initialState(start);
    findings.addAll(new Assembly(tree).assemble(startTime, start));
    if (isAssembled()) {
      RankAnalysis analysis = new RankAnalysis(tree, startTime, start);
      rank = analysis.rank();
      againstProjection = analysis.againstProjection();
      findings.addAll(analysis.findings(startTime));
    } else {
      rank = 0;
      againstProjection = Optional.empty();
    }
  }

  private ClosedMechanism(ClosedMechanism other, LoopTerms code) {
    tree = other.tree;
    description = other.description;
    startTime = other.startTime;
    start = other.start;
    rank = other.rank;
    againstProjection = other.againstProjection;
    findings.addAll(other.findings);
    jointOfVelocity = other.jointOfVelocity;
    terms = Optional.of(code);
  }

  private List<JointVariables> joints(Mechanism mechanism) {
    List<JointVariables> joints = new ArrayList<>();
    for (int j = 0; j < mechanism.joints().size(); j++) {
      if (!mechanism.isDriven(j)) {
        Joint joint = mechanism.joints().get(j);
        int at = mechanism.velocityOffset(j);
        Arrays.fill(jointOfVelocity, at, at + joint.type().velocityCount(), joints.size());
        joints.add(new JointVariables(joint.name(), joint.type()));
      }
    }
    return joints;
  }

  /** Returns whether the loops are closed at the start; if not, {@link #findings()} says why. */
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

  /** Returns names and settings. */
  public ModelDescription description() {
    return description;
  }

  /**
   * Returns the same mechanism with generated code for the terms of its equations. The code has a
   * workspace, so only one model may be made of the result.
   */
  public ClosedMechanism evaluatedBy(LoopTerms code) {
    return new ClosedMechanism(this, code);
  }

  /** Returns a workspace of its equations, evaluated by generated code where there is any. */
  public ClosedTree newEquations(UserForceSource userForces) {
    return terms
        .<ClosedTree>map(code -> new GeneratedTreeTerms(this, userForces, code))
        .orElseGet(() -> new ClosedTree(tree, userForces));
  }

  /** Returns the number of independent equations of the loops. */
  public int rank() {
    return rank;
  }

  /** Returns the number of degrees of freedom that the loops leave. */
  public int freedom() {
    return tree.stateVelocityCount - rank;
  }

  /** Returns whether a prescribed motion or a coupling depends on time and therefore does work. */
  public boolean isMovedByTime() {
    List<Expression> prescribed = new ArrayList<>();
    tree.mechanism().motions().forEach(motion -> prescribed.addAll(motion.coordinates()));
    for (LoopClosure closure : tree.mechanism().closures()) {
      if (closure instanceof JointClosure cut) {
        prescribed.addAll(cut.motion());
      } else if (closure instanceof CoordinateClosure coupling) {
        prescribed.add(coupling.relation());
      }
    }
    return new Tape(prescribed).leaves().stream().anyMatch(Expression.Time.class::isInstance);
  }

  /** Returns the time at which the loops are closed, s. */
  public double startTime() {
    return startTime;
  }

  /** Returns the assembled state [q; v] at the start. */
  public double[] start() {
    return start.clone();
  }

  /** Returns the index in {@code description().joints()} of the joint a velocity belongs to. */
  public int jointOfVelocity(int velocity) {
    return jointOfVelocity[velocity];
  }
}
