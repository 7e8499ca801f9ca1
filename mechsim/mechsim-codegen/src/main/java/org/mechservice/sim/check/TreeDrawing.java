package org.mechservice.sim.check;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Draws a mechanism's tree, one body a line.
 *
 * <pre>
 * Ground
 * +- j1 (R): bar1, 1 kg
 *    +- j2 (R): bar2, 1 kg
 * </pre>
 *
 * <p>Bodies that are deeper than {@value #MOST_LEVELS} levels are drawn at that level and name the
 * body they hang on, so that the drawing of a long chain grows with its length and not with its
 * square:
 *
 * <pre>
 *    +- j47 (R): bar47, 1 kg, on bar46
 *    +- j48 (R): bar48, 1 kg, on bar47
 * </pre>
 */
public final class TreeDrawing {
  /** Levels that are shown by indentation: as many as a line of a terminal has room for. */
  static final int MOST_LEVELS = 20;

  /** A body still to be drawn. */
  private record Branch(int body, int depth) {}

  private TreeDrawing() {}

  /** Returns the lines of the drawing. */
  public static List<String> of(Mechanism mechanism) {
    List<List<Integer>> childrenOf = childrenOf(mechanism);
    List<String> lines = new ArrayList<>();
    Deque<Branch> open = new ArrayDeque<>(List.of(new Branch(Mechanism.ROOT, 0)));
    while (!open.isEmpty()) {
      Branch branch = open.pop();
      lines.add(line(mechanism, branch));
      List<Integer> children = childrenOf.get(branch.body() + 1);
      for (int i = children.size() - 1; i >= 0; i--) {
        open.push(new Branch(children.get(i), branch.depth() + 1));
      }
    }
    return lines;
  }

  /** Returns the children of each body by index + 1, those of the root at 0, in file order. */
  private static List<List<Integer>> childrenOf(Mechanism mechanism) {
    List<List<Integer>> children = new ArrayList<>();
    for (int i = 0; i <= mechanism.bodies().size(); i++) {
      children.add(new ArrayList<>());
    }
    for (Joint joint : mechanism.joints()) {
      children.get(joint.attachment().parent() + 1).add(joint.attachment().child());
    }
    return children;
  }

  private static String line(Mechanism mechanism, Branch branch) {
    if (branch.body() == Mechanism.ROOT) {
      return mechanism.root().name();
    }
    Joint joint = mechanism.joints().get(mechanism.jointOf(branch.body()));
    Body body = mechanism.bodies().get(branch.body());
    String mass = body.isMassless() ? "massless" : ShortestDecimal.format(body.mass()) + " kg";
    boolean deep = branch.depth() > MOST_LEVELS;
    return "   ".repeat((deep ? MOST_LEVELS : branch.depth()) - 1)
        + "+- "
        + joint.name()
        + " ("
        + joint.type()
        + "): "
        + body.name()
        + ", "
        + mass
        + (deep ? ", on " + mechanism.bodies().get(joint.attachment().parent()).name() : "");
  }
}
