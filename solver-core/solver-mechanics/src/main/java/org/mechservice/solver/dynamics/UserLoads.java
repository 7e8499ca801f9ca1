package org.mechservice.solver.dynamics;

import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.dynamics.derivative.ResidualJacobian;
import org.mechservice.solver.force.ForceSet;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.force.ForceElement;
import org.mechservice.solver.mechanism.force.UserForceElement;

/**
 * The loads of user forces as inputs of generated code. The inputs hold the parameters of the
 * model, then the wrench on each link of its {@link TreeGeometry}, then the force on each extended
 * velocity. This class sweeps the motion that the forces read; all other forces are in the
 * generated code. Workspace of one run and thread.
 */
public final class UserLoads {
  private final TreeMotion motion;
  private final TreeLoads loads;
  private final WorldMotion world;
  private final double[] inputs;
  private final int first;
  private Optional<Defects.Defect> defect = Optional.empty();

  /**
   * @param inputs inputs of the generated code, see {@link #inputs}; each evaluation overwrites its
   *     loads
   * @throws IllegalArgumentException if a user force cannot be created, or needs an element that
   *     does not exist
   */
  public UserLoads(Mechanism mechanism, UserForceSource source, double[] inputs) {
    motion = new TreeMotion(new TreeGeometry(withUserForcesAlone(mechanism)));
    loads = new TreeLoads(motion, source);
    world = new WorldMotion(motion);
    this.inputs = inputs;
    first = mechanism.parameters().size();
  }

  private static Mechanism withUserForcesAlone(Mechanism m) {
    List<ForceElement> forces =
        m.forces().stream().filter(UserForceElement.class::isInstance).toList();
    Mechanism alone =
        new Mechanism(
            m.name(),
            m.root(),
            m.gravity(),
            m.bodies(),
            m.joints(),
            m.motions(),
            m.startRoles(),
            m.closures(),
            forces,
            m.parameters());
    return alone.withFurtherStates(m.furtherStates()).withArmatures(m.armatures());
  }

  /**
   * Returns the inputs of generated code: the parameters of a mechanism, SI units, followed by
   * zeros for the loads.
   */
  public static double[] inputs(Mechanism mechanism) {
    TreeGeometry tree = new TreeGeometry(mechanism);
    List<Parameter> parameters = mechanism.parameters();
    double[] inputs = new double[parameters.size() + 6 * tree.linkCount + tree.velocityCount];
    for (int i = 0; i < parameters.size(); i++) {
      inputs[i] = parameters.get(i).value();
    }
    return inputs;
  }

  /**
   * Evaluates the forces.
   *
   * @param y state; not modified
   * @return {@link ExplicitModel#REGULAR}, or {@link Defects#DEFECT}: see {@link #defect}
   */
  public int evaluate(double t, double[] y) {
    motion.sweep(t, y);
    if (loads.evaluate(t) != ForceSet.REGULAR) {
      defect = Optional.of(loads.forces().defect());
      return Defects.DEFECT;
    }
    int links = loads.wrench().length;
    System.arraycopy(loads.wrench(), 0, inputs, first, links);
    System.arraycopy(loads.tau(), 0, inputs, first + links, loads.tau().length);
    return ExplicitModel.REGULAR;
  }

  /**
   * Returns why the last evaluation failed.
   *
   * @throws IllegalStateException if none did
   */
  Defects.Defect defect() {
    return defect.orElseThrow(() -> new IllegalStateException("no evaluation has failed"));
  }

  /**
   * Adds the derivatives of the forces at the state of the last evaluation.
   *
   * @return whether they are finite; see {@link #defect}
   */
  boolean linearise(double t, ResidualJacobian jacobian) {
    jacobian.evaluateNothing();
    if (loads.forces().linearise(t, jacobian.forces()) != ForceSet.REGULAR) {
      defect = Optional.of(loads.forces().defect());
      return false;
    }
    jacobian.finish();
    return true;
  }

  /** Returns the motion, swept by {@link #evaluate}. */
  TreeMotion motion() {
    return motion;
  }

  /** Returns the forces of the last evaluation. */
  public ForceSet forces() {
    return loads.forces();
  }

  /** Writes the poses of all bodies at a state. */
  void poses(double t, double[] y, double[] poses) {
    motion.sweep(t, y);
    world.poses(poses);
  }
}
