package org.mechservice.solver.closure;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.closure.assembly.ClosedStart;
import org.mechservice.solver.closure.equations.LoopTerms;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * A mechanism with closed loops after assembly: its loops are closed at the start and the rank of
 * its loop equations is known. Models are made from it. Immutable, apart from generated code that
 * evaluates its equations.
 */
public final class ClosedMechanism {
  private final ClosedStart start;
  private final ModelDescription description;
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
    this(mechanism, formulation, defaults, new ClosedStart(mechanism, defaults.tStart()));
  }

  /**
   * Takes a mechanism that has been assembled.
   *
   * @param start at the start time of {@code defaults}
   */
  public ClosedMechanism(
      Mechanism mechanism, String formulation, RunSettings defaults, ClosedStart start) {
    this.start = start;
    terms = Optional.empty();
    jointOfVelocity = new int[mechanism.velocityCount()];
    description =
        new ModelDescription(
            mechanism.name(), formulation, joints(mechanism), mechanism.stateVariables(), defaults);
  }

  private ClosedMechanism(ClosedMechanism other, LoopTerms code) {
    start = other.start;
    description = other.description;
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

  /** Returns the closed start, with what there is to say of the loops. */
  public ClosedStart start() {
    return start;
  }

  /** Returns the tree that is left when the loops are opened. */
  public TreeGeometry tree() {
    return start.tree();
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
        .<ClosedTree>map(
            code ->
                code instanceof LoopTerms.Recursive recursive
                    ? new GeneratedRecursion(this, userForces, recursive)
                    : new GeneratedTreeTerms(this, userForces, code))
        .orElseGet(() -> new ClosedTree(tree(), userForces));
  }

  /** Returns the number of degrees of freedom that the loops leave. */
  public int freedom() {
    return tree().stateVelocityCount - start.rank();
  }

  /** Returns whether a prescribed motion or a coupling depends on time and therefore does work. */
  public boolean isMovedByTime() {
    List<Expression> prescribed = new ArrayList<>();
    tree().mechanism().motions().forEach(motion -> prescribed.addAll(motion.coordinates()));
    for (LoopClosure closure : tree().mechanism().closures()) {
      if (closure instanceof JointClosure cut) {
        prescribed.addAll(cut.motion());
      } else if (closure instanceof CoordinateClosure coupling) {
        prescribed.add(coupling.relation());
      }
    }
    return new Tape(prescribed).leaves().stream().anyMatch(Expression.Time.class::isInstance);
  }

  /** Returns the index in {@code description().joints()} of the joint a velocity belongs to. */
  public int jointOfVelocity(int velocity) {
    return jointOfVelocity[velocity];
  }
}
