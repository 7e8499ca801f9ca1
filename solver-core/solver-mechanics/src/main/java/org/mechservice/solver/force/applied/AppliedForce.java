package org.mechservice.solver.force.applied;

import java.util.List;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.force.ForceElement;

/**
 * One applied force, evaluated on a motion that the caller sweeps. Workspace of one thread; nothing
 * allocates unless something fails.
 */
public abstract class AppliedForce {
  private final ForceElement element;
  private Defect defect = new Defect(MessageCode.FORCE_COEFFICIENT, "", "", "");

  public AppliedForce(ForceElement element) {
    this.element = element;
  }

  /** Returns its output values in a mechanism. */
  public List<Variable> variables(Mechanism mechanism) {
    return element.values(mechanism::jointOf);
  }

  /**
   * Sets the values of tunable parameters.
   *
   * @return false if a coefficient is not finite or out of range; see {@link #defect()}
   */
  public abstract boolean parameters(double[] values);

  /**
   * Adds its wrenches and joint forces.
   *
   * @return false if they are not finite or not defined; see {@link #defect()}
   */
  public abstract boolean apply(double t, double[] wrench, double[] tau);

  /**
   * Adds its derivatives at the state of the last {@link #apply}; returns false if they are not
   * finite.
   */
  public abstract boolean linearise(double t, ForceJacobian sink);

  /**
   * Adds the derivative of its wrenches and joint forces by a further state, at the state of the
   * last {@link #apply}. Most forces do not depend on further states.
   *
   * @param state index among the further states
   */
  public void addByState(int state, double[] wrench, double[] tau) {}

  /** Returns its potential energy in the state of the last {@link #apply}, J. */
  public abstract double potentialEnergy();

  /** Returns the power of its non-conservative part at the state of the last {@link #apply}, W. */
  public abstract double power();

  /** Writes the values of the last {@link #apply}. */
  public abstract void values(double[] out, int at);

  /**
   * Returns whether its derivatives are those of joint forces by coordinates of the same link, and
   * of wrenches by the motion of the same link or of a link next to it.
   */
  public boolean isLocal() {
    return false;
  }

  /** Adds the pairs of links that it couples. */
  public abstract void couplings(Couplings couplings);

  /** Stores the unwrapped angle of a cut joint after an accepted step. */
  public void accepted() {}

  /** Returns why the last call failed. */
  public Defect defect() {
    return defect;
  }

  /** Stores a failure and returns false. */
  public boolean fail(MessageCode code, String cause, String advice) {
    defect = new Defect(code, "force " + element.name(), cause, advice);
    return false;
  }

  /** Stores that a coefficient cannot be used and returns false. */
  public boolean refuse(String quantity, double value, String condition) {
    return fail(
        MessageCode.FORCE_COEFFICIENT,
        "The " + quantity + " is " + value + "; it must be " + condition + ".",
        "Check the parameters it is computed from.");
  }

  /** Stores that a result is not finite and returns false. */
  public boolean notFinite(String quantity, double value) {
    return fail(
        MessageCode.FORCE_NOT_FINITE,
        "The " + quantity + " is not finite but " + value + ".",
        "Look for a division by zero or a root of a negative number in its law.");
  }
}
