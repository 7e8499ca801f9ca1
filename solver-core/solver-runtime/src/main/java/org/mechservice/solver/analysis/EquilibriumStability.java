package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.analysis.equation.RestingLinks;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Whether an equilibrium is unstable or not isolated. Where {@link ProvenStability} does not say
 * that it is neither, eigenvalues decide; for large mechanisms with symmetric M, C and K by the
 * numbers of negative eigenvalues of forms.
 *
 * <p>With positive M and C that is not negative, each growing motion e^(st) x has a real s > 0: of
 * s² x*Mx + s x*Cx + x*Kx = 0 only real roots have a positive real part. The form s² M + s C + K
 * grows with s, and has a negative eigenvalue if and only if s is less than the fastest growth. So
 * that is found by halving, and its x by inverse iteration. What has neither grown nor come back
 * after a million periods of the fastest motion has no restoring force: dampers do not matter.
 */
final class EquilibriumStability {
  /** Growth rate, as a fraction of the largest eigenvalue, above which a mode is unstable. */
  private static final double GROWS = 1e-6;

  /** Factor of the search for bounds of a growth. */
  private static final double STRIDE = 16;

  /** Relative width at which halving ends, and steps of inverse iteration behind it. */
  private static final double HALVED = 1e-6;

  private static final int STEPS = 8;

  private EquilibriumStability() {}

  /** Returns notes on an equilibrium by matrices in the free directions. */
  static List<Note> judged(EquationsOfMotion equations, double t, Linearisation linear) {
    List<Note> notes = new ArrayList<>();
    if (ProvenStability.of(linear, Modes.ZERO)) {
      return notes;
    }
    double[] system = linear.freedom() == 0 ? new double[0] : linear.system();
    if (system.length == 0) {
      return notes;
    }
    Modes modes = new Modes(linear, linear.changing(system));
    double largest = 0;
    for (int k = 0; k < modes.count(); k++) {
      largest = Math.max(largest, Math.hypot(modes.growth(k), modes.angularFrequency(k)));
    }
    int growing = -1;
    int neutral = -1;
    for (int k = 0; k < modes.count(); k++) {
      boolean grows = modes.growth(k) > GROWS * largest;
      growing = grows && (growing < 0 || modes.growth(k) > modes.growth(growing)) ? k : growing;
      neutral = modes.frequency(k) == 0 ? k : neutral;
    }
    if (growing >= 0) {
      double[] shape = shape(equations, linear, modes, growing);
      notes.add(unstable(equations, t, modes.growth(growing), shape));
    }
    if (neutral >= 0) {
      notes.add(notUnique(equations, t, shape(equations, linear, modes, neutral)));
    }
    return notes;
  }

  private static double[] shape(
      EquationsOfMotion equations, Linearisation linear, Modes modes, int k) {
    double[] re = new double[equations.nv + linear.changingCount()];
    double[] im = new double[re.length];
    modes.shape(k, equations.unit, re, im);
    return re;
  }

  /**
   * Returns notes on an equilibrium by links.
   *
   * @param links evaluated there
   */
  static List<Note> judged(EquationsOfMotion equations, double t, RestingLinks links) {
    MotionForms forms = MotionForms.of(links);
    if (ProvenStability.of(forms, Modes.ZERO)) {
      return List.of();
    }
    if (!forms.isSymmetric() || !forms.factor(1, 0, 0)) {
      return byEigenvalues(equations, t, links);
    }
    double fastest = Math.sqrt(ProvenStability.largest(forms, 0, 0, 1));
    double a = forms.isDamped() ? ProvenStability.largest(forms, 0, 1, 0) : 0;
    if (forms.isDamped() && !ProvenStability.isNotNegative(forms, a)) {
      return byEigenvalues(equations, t, links);
    }
    List<Note> notes = new ArrayList<>();
    double zero = GROWS * fastest;
    double[] x = new double[equations.nv];
    int growing = links.negative(zero * zero, 0, 1);
    int held = links.negative(-zero * zero, 0, 1);
    if (growing < 0 || held < 0) {
      return byEigenvalues(equations, t, links);
    }
    if (growing > 0) {
      notes.add(unstable(equations, t, growth(links, zero, x), x));
    }
    if (held > growing) {
      links.negative(zero * zero, 0, 1);
      iterate(links, x);
      notes.add(notUnique(equations, t, x));
    }
    return notes;
  }

  private static List<Note> byEigenvalues(
      EquationsOfMotion equations, double t, RestingLinks links) {
    try {
      double[] y = links.state();
      return judged(equations, t, new Linearisation(equations, t, y, new double[equations.nv]));
    } catch (Linearisation.NotLinearised e) {
      throw new IllegalStateException("forces had derivatives at this state", e);
    }
  }

  /** Returns the number of motions that grow faster than with s, 1/s. */
  private static int negative(RestingLinks links, double s) {
    return links.negative(s * s, s, 1);
  }

  /**
   * Finds the fastest growth, 1/s, where K has a negative eigenvalue.
   *
   * @param start a first try, 1/s
   * @param x its displacements; overwritten
   */
  private static double growth(RestingLinks links, double start, double[] x) {
    double below = start;
    while (negative(links, below) == 0) {
      below /= STRIDE;
    }
    double above = STRIDE * below;
    while (negative(links, above) > 0) {
      below = above;
      above *= STRIDE;
    }
    while (above > (1 + HALVED) * below) {
      double middle = Math.sqrt(below * above);
      if (negative(links, middle) > 0) {
        below = middle;
      } else {
        above = middle;
      }
    }
    negative(links, above);
    iterate(links, x);
    double m = form(links, 1, 0, 0, x);
    double c = form(links, 0, 1, 0, x);
    double k = form(links, 0, 0, 1, x);
    return 0.5 * (Math.sqrt(c * c - 4 * m * k) - c) / m;
  }

  private static double form(RestingLinks links, double m, double c, double k, double[] x) {
    double[] product = new double[x.length];
    links.multiply(m, c, k, x, product);
    double sum = 0;
    for (int i = 0; i < x.length; i++) {
      sum += x[i] * product[i];
    }
    return sum;
  }

  /** Iterates inversely with the last factors, from a random motion. */
  private static void iterate(RestingLinks links, double[] x) {
    double[] force = new Random(161803).doubles(x.length, -1, 1).toArray();
    for (int step = 0; step < STEPS; step++) {
      System.arraycopy(force, 0, x, 0, x.length);
      links.solve(x);
      double largest = 0;
      for (double element : x) {
        largest = Math.max(largest, Math.abs(element));
      }
      for (int i = 0; i < x.length; i++) {
        x[i] /= largest;
      }
      links.multiply(1, 0, 0, x, force);
    }
  }

  private static Note unstable(
      EquationsOfMotion equations, double t, double growth, double[] shape) {
    String text =
        String.format(
            Locale.ROOT,
            "The equilibrium is unstable: a small disturbance grows with %.3g/s, most of all in"
                + " %s.",
            growth,
            mostMoved(equations, shape));
    return new Note(MessageCode.UNSTABLE_EQUILIBRIUM, t, true, text);
  }

  private static Note notUnique(EquationsOfMotion equations, double t, double[] shape) {
    String text =
        "The equilibrium is not the only one: nothing brings "
            + mostMoved(equations, shape)
            + " back.";
    return new Note(MessageCode.EQUILIBRIUM_NOT_UNIQUE, t, true, text);
  }

  /** Returns the name of the part that a motion moves most. */
  private static String mostMoved(EquationsOfMotion equations, double[] shape) {
    int most = 0;
    for (int i = 1; i < equations.nv; i++) {
      if (Math.abs(shape[i]) / equations.unit[i] > Math.abs(shape[most]) / equations.unit[most]) {
        most = i;
      }
    }
    return new CoordinateNames(equations.tree.mechanism()).part(most);
  }
}
