package org.mechservice.sim.scene.forecast;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.scene.Finding;
import org.mechservice.solver.api.run.RunSettings;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.IntegrationMethod;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.recursion.MassiveRods;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.text.Origin;

/**
 * Warns before a run of a large mechanism if a method that was asked for keeps dense matrices of
 * it, so that its cost grows with the square or the cube of the mechanism, and says why.
 */
final class DenseForecast {
  /** Velocities from which a dense matrix takes longer than everything else of a step. */
  private static final int MANY = 300;

  /** Pairs of coordinates that influence each other, likewise; a chain of 300 links has as many. */
  private static final long MANY_PAIRS = 44_000;

  private static final String BESIDE_ODE15S = "formulation RR-JF with ode15sR";
  private static final String BESIDE_RR = "formulation RR-JF";

  private DenseForecast() {}

  private static boolean isStiff(String integrator) {
    return integrator.equals(IntegrationMethod.ODE15S.label());
  }

  /**
   * Returns the warnings.
   *
   * @param formulation requested formulation, {@code auto} or a name
   * @param settings settings of the run, with its integrator
   */
  static List<Finding> of(MechmlModel model, String formulation, RunSettings settings) {
    Mechanism mechanism = model.mechanism();
    List<Finding> findings = new ArrayList<>();
    if (mechanism.velocityCount() < MANY) {
      return findings;
    }
    TreeGeometry tree = new TreeGeometry(mechanism);
    boolean loops = !mechanism.closures().isEmpty();
    if (isStiff(settings.integrator())) {
      int rank = loops ? model.closedStart(settings.tStart()).rank() : 0;
      int free = mechanism.velocityCount() - rank;
      if (free >= MANY) {
        findings.add(ofStates(free, tree));
      }
    } else if (formulation.equalsIgnoreCase(Formulation.RR.label()) && pairs(tree) >= MANY_PAIRS) {
      findings.add(
          ofPairs("RR takes differences of its residual for", tree, advice(BESIDE_RR, tree)));
    } else if (formulation.equalsIgnoreCase(Formulation.RR_JF.label())
        && pairs(tree) >= MANY_PAIRS
        && !obstacle(tree).isEmpty()) {
      String why = obstacle(tree) + ", and a matrix has to be formed of";
      findings.add(ofPairs(why, tree, ""));
    }
    if (loops && !new MassiveRods(tree).areLight()) {
      findings.add(
          finding(
              "a rod of a DISTConstraint has more than a thousand times the mass of a body at its"
                  + " end: accelerations are found with dense matrices of the "
                  + mechanism.velocityCount()
                  + " coordinates; give the body its mass, or let a body take the place of the"
                  + " rod"));
    }
    return findings;
  }

  private static Finding ofStates(int free, TreeGeometry tree) {
    int unknowns = 2 * free;
    return finding(
        String.format(
            Locale.ROOT,
            "ode15s keeps a dense matrix of the %d independent states (%d MB) and differences the"
                + " accelerations for each of them; its factors cost the cube of their number%s",
            unknowns,
            Math.round(8e-6 * unknowns * unknowns),
            advice(BESIDE_ODE15S, tree)));
  }

  /**
   * Returns the advice to keep the equations of a step by links, if that is possible.
   *
   * @param method another than the one that runs
   */
  private static String advice(String method, TreeGeometry tree) {
    return pairs(tree) < MANY_PAIRS || obstacle(tree).isEmpty()
        ? "; " + method + " keeps the equations of a step in their sparsity"
        : "";
  }

  private static Finding ofPairs(String what, TreeGeometry tree, String advice) {
    return finding(
        String.format(
            Locale.ROOT,
            "%s the %d pairs of coordinates that influence each other along the chains of this"
                + " model; the cost of a step grows with the cube of their length%s",
            what,
            pairs(tree),
            advice));
  }

  private static Finding finding(String text) {
    return new Finding(MessageCode.DENSE_MATRICES, text, Origin.NONE);
  }

  /** Returns the number of pairs of velocities one of which lies on the other's way to the root. */
  private static long pairs(TreeGeometry tree) {
    int[] onWay = new int[tree.linkCount];
    long sum = 0;
    for (int link = 0; link < tree.linkCount; link++) {
      int above = tree.parent[link] == TreeGeometry.ROOT ? 0 : onWay[tree.parent[link]];
      int count = tree.driven[link] ? 0 : tree.kind[link].velocityCount();
      sum += (long) count * above + count * (count - 1) / 2;
      onWay[link] = above + count;
    }
    return sum;
  }

  /** Returns why the equations of a step of RR-JF are not kept by links; empty if they are. */
  private static String obstacle(TreeGeometry tree) {
    return new MassiveRods(tree).isEmpty()
        ? ""
        : "a rod with mass couples links that are not neighbours";
  }
}
