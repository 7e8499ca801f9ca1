package org.mechservice.solver.api.run;

/**
 * The verdict on the stiffness of a motion, by the eigenvalues λ of its linearised equations at
 * some times along it: the one measure of run reports, of the page of {@code mech report}, of the
 * choice {@code auto} and of forecasts.
 *
 * <p>Of each time counts the fastest motion, max |λ|. It is damped if it and all motions at least
 * half as fast decay with a damping ratio of 0.05: when they are gone, the limit of stability keeps
 * the steps of an explicit method short. A fast motion that is not damped counts instead of them:
 * every method has to follow what excites it. The mean of |λ| over all times, times the length of
 * the motion, counts how many time constants of damped motions pass, and how many radians of
 * others: a contact that is closed for a hundredth of the time counts for that part alone. From 500
 * on there is a verdict: a motion with the smallest damping ratio has then decayed by e⁻²⁵ = 1e-11,
 * below every usual tolerance.
 *
 * <p>Not thread-safe.
 */
public final class Stiffness {
  /** Usual number of times looked at, the start and the end among them, evenly distributed. */
  public static final int USUAL_TIMES = 11;

  /** Time constants or radians of the fastest motion from which there is a verdict. */
  private static final double MANY = 500;

  /** Smallest damping ratio of a motion that decays before a method must follow it. */
  private static final double DAMPED = 0.05;

  /** Part of the largest modulus from which another motion counts as fast, too. */
  private static final double FAST = 0.5;

  private int times;
  private double damped;
  private double undamped;

  /** Meaning of the spectrum for the choice of an integrator. */
  public enum Verdict {
    /** Nothing decays or swings much faster than the length of the motion. */
    NOT_STIFF,
    /** Fast decay: stability limits explicit methods. */
    STIFF,
    /** Fast motions that hardly decay: an integrator must resolve them once they are excited. */
    OSCILLATORY
  }

  /**
   * Adds a time of the motion.
   *
   * @param real Re λ of its eigenvalues, at least of the fastest, 1/s; not modified
   * @param imaginary Im λ, rad/s; not modified
   */
  public void add(double[] real, double[] imaginary) {
    times++;
    if (real.length > 0) {
      int at = deciding(real, imaginary);
      double modulus = Math.hypot(real[at], imaginary[at]);
      if (isDamped(real[at], imaginary[at])) {
        damped += modulus;
      } else {
        undamped += modulus;
      }
    }
  }

  /**
   * Returns the eigenvalue that decides: the fastest of those that are not damped among the fast
   * ones, or else the fastest.
   *
   * @param real Re λ of the eigenvalues, at least one, 1/s; not modified
   * @param imaginary Im λ, rad/s; not modified
   */
  public static int deciding(double[] real, double[] imaginary) {
    double fastest = 0;
    for (int i = 0; i < real.length; i++) {
      fastest = Math.max(fastest, Math.hypot(real[i], imaginary[i]));
    }
    int deciding = 0;
    double rank = -1;
    for (int i = 0; i < real.length; i++) {
      double modulus = Math.hypot(real[i], imaginary[i]);
      boolean followed = modulus >= FAST * fastest && !isDamped(real[i], imaginary[i]);
      double own = followed ? fastest + modulus : modulus;
      if (own > rank) {
        rank = own;
        deciding = i;
      }
    }
    return deciding;
  }

  /**
   * Returns whether a motion decays soon, so that an implicit method need not follow it.
   *
   * @param real Re λ, 1/s
   * @param imaginary Im λ, rad/s
   */
  public static boolean isDamped(double real, double imaginary) {
    return real < 0 && -real >= DAMPED * Math.hypot(real, imaginary);
  }

  /**
   * Returns how many time constants of damped motions pass.
   *
   * @param length of the motion, s
   */
  public double timeConstants(double length) {
    return times == 0 ? 0 : damped / times * length;
  }

  /**
   * Returns how many radians of motions pass that are not damped.
   *
   * @param length of the motion, s
   */
  public double radians(double length) {
    return times == 0 ? 0 : undamped / times * length;
  }

  /**
   * Returns the verdict on a motion; that it is not stiff, if no time was added.
   *
   * @param length of the motion, s
   */
  public Verdict verdict(double length) {
    double timeConstants = timeConstants(length);
    double radians = radians(length);
    if (Math.max(timeConstants, radians) <= MANY) {
      return Verdict.NOT_STIFF;
    }
    return timeConstants >= radians ? Verdict.STIFF : Verdict.OSCILLATORY;
  }
}
