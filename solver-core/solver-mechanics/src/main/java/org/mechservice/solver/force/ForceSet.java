package org.mechservice.solver.force;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.force.applied.AppliedForce;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * All applied forces of a mechanism except gravity, evaluated on a motion that the caller sweeps.
 * Workspace of one thread; nothing allocates after construction unless something fails.
 *
 * <p>Call {@link #apply} after {@link TreeMotion#sweep} (with poses in the world); all other
 * methods refer to the state of the last {@code apply}. Forces are added in file order, so sums
 * round identically on every machine.
 */
public final class ForceSet {
  /** Result of {@link #apply} if every force has a value. */
  public static final int REGULAR = -1;

  private final Mechanism mechanism;
  private final List<String> names = new ArrayList<>();
  private final AppliedForce[] forces;
  private final int[] valueAt;
  private int failed = REGULAR;

  /**
   * Prepares the forces of a mechanism that has no user forces.
   *
   * @param motion motion of the tree
   * @throws IllegalArgumentException if a force refers to a body, joint or coordinate that does not
   *     exist, if its coefficients do not depend on parameters only, or cannot be used
   */
  public ForceSet(TreeMotion motion) {
    this(motion, UserForceSource.NONE);
  }

  /**
   * Prepares the forces of a mechanism.
   *
   * @param motion motion of the tree
   * @param source creates the user forces
   * @throws IllegalArgumentException as {@link #ForceSet(TreeMotion)}; or if a user force cannot be
   *     created, or needs an element that does not exist
   */
  public ForceSet(TreeMotion motion, UserForceSource source) {
    mechanism = motion.tree().mechanism();
    List<ForceElement> elements = mechanism.forces();
    forces = new AppliedForce[elements.size()];
    valueAt = new int[forces.length + 1];
    ForceAssembly assembly = new ForceAssembly(motion, source);
    for (int i = 0; i < forces.length; i++) {
      names.add(elements.get(i).name());
      forces[i] = assembly.at(elements.get(i));
      valueAt[i + 1] = valueAt[i] + forces[i].variables(mechanism).size();
    }
    double[] start = mechanism.parameters().stream().mapToDouble(Parameter::value).toArray();
    if (!parameters(start)) {
      Defect defect = defect();
      throw new IllegalArgumentException(
          defect.code() + " " + defect.part() + ": " + defect.cause() + " " + defect.advice());
    }
  }

  /** Returns the number of forces. */
  public int count() {
    return forces.length;
  }

  /**
   * Sets the values of tunable parameters; initially they are those of the mechanism.
   *
   * @param values in the order of the mechanism's parameters, SI units; not modified
   * @return false if a coefficient gets a value that cannot be used; see {@link #defect()}
   */
  public boolean parameters(double[] values) {
    for (int i = 0; i < forces.length; i++) {
      if (!forces[i].parameters(values)) {
        failed = i;
        return false;
      }
    }
    return true;
  }

  /**
   * Adds all forces.
   *
   * @param t time, s
   * @param wrench [moment; force] on each link in its axes at its reference point, 6 per link, N·m,
   *     N; added to
   * @param tau joint forces, one per extended velocity, N·m or N; added to
   * @return {@link #REGULAR}, or the index in {@code Mechanism.forces()} of a force that is not
   *     finite or not defined here; {@link #defect()} then says why
   */
  public int apply(double t, double[] wrench, double[] tau) {
    for (int i = 0; i < forces.length; i++) {
      if (!forces[i].apply(t, wrench, tau)) {
        failed = i;
        return i;
      }
    }
    return REGULAR;
  }

  /**
   * Adds the derivatives of all forces at the state of the last {@link #apply}.
   *
   * @return {@link #REGULAR}, or the index of a force whose derivative is not finite
   */
  public int linearise(double t, ForceJacobian sink) {
    for (int i = 0; i < forces.length; i++) {
      if (!forces[i].linearise(t, sink)) {
        failed = i;
        return i;
      }
    }
    return REGULAR;
  }

  /**
   * Adds the derivatives of all forces by a further state, at the state of the last {@link #apply}.
   *
   * @param state index among the further states
   * @param wrench as {@link #apply} takes it
   * @param tau likewise
   */
  public void addByState(int state, double[] wrench, double[] tau) {
    for (AppliedForce force : forces) {
      force.addByState(state, wrench, tau);
    }
  }

  /**
   * Returns why the last call failed.
   *
   * @throws IllegalStateException if none did
   */
  public Defect defect() {
    if (failed == REGULAR) {
      throw new IllegalStateException("no force has failed");
    }
    return forces[failed].defect();
  }

  /** Returns the potential energy of all forces that have one, without gravity, J. */
  public double potentialEnergy() {
    double sum = 0;
    for (AppliedForce force : forces) {
      sum += force.potentialEnergy();
    }
    return sum;
  }

  /**
   * Returns the power of all forces without potential energy, W, positive into the mechanism: the
   * rate of the mechanical energy.
   */
  public double power() {
    double sum = 0;
    for (AppliedForce force : forces) {
      sum += force.power();
    }
    return sum;
  }

  /** Returns the sum of the absolute powers of the single forces, W. */
  public double turnover() {
    double sum = 0;
    for (AppliedForce force : forces) {
      sum += Math.abs(force.power());
    }
    return sum;
  }

  /** Returns the output columns of the forces, {@code <force>.<value>}, in file order. */
  public List<Variable> columns() {
    List<Variable> columns = new ArrayList<>();
    for (int i = 0; i < forces.length; i++) {
      for (Variable value : forces[i].variables(mechanism)) {
        columns.add(new Variable(names.get(i) + "." + value.name(), value.unit()));
      }
    }
    return columns;
  }

  /**
   * Writes the values of {@link #columns}.
   *
   * @param out overwritten from {@code at}
   */
  public void values(double[] out, int at) {
    for (int i = 0; i < forces.length; i++) {
      forces[i].values(out, at + valueAt[i]);
    }
  }

  /** Returns whether all forces have derivatives by the nearest links and coordinates alone. */
  public boolean isLocal() {
    return Arrays.stream(forces).allMatch(AppliedForce::isLocal);
  }

  /** Adds the pairs of links whose ancestors are coupled in the Jacobian, some more than once. */
  public void couplings(Couplings couplings) {
    for (AppliedForce force : forces) {
      force.couplings(couplings);
    }
  }

  /**
   * Records that the state of the last {@link #apply} was accepted: angles of cut joints are
   * unwrapped from there.
   */
  public void accepted() {
    for (AppliedForce force : forces) {
      force.accepted();
    }
  }
}
