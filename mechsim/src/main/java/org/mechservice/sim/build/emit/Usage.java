package org.mechservice.sim.build.emit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.sim.symbolic.Operation;
import org.mechservice.sim.symbolic.Program;
import org.mechservice.sim.symbolic.Scalar;

/**
 * Where the values of a program are used, and which of them get a place of their own.
 *
 * <p>A value is computed in the section in which it arose. What is used once, in that section, is
 * written out where it is used; a change of sign always is. Sines and cosines come before all
 * sections.
 */
final class Usage {
  /** A longer expression is cut in two, so that people can read it. */
  private static final int LONGEST_EXPRESSION = 14;

  private final Program program;
  private final List<Program.Section> sections;
  private final int[] live;
  private final List<List<Integer>> usedIn = new ArrayList<>();
  private final boolean[] placed;
  private final List<List<Scalar>> placedIn = new ArrayList<>();
  private final int[] length;
  private final List<Scalar> given;
  private final List<Scalar> angles;

  Usage(Program program) {
    this.program = program;
    this.sections = program.sections();
    this.live = program.uses();
    this.placed = new boolean[live.length];
    this.length = new int[live.length];
    for (int id = 0; id < live.length; id++) {
      usedIn.add(new ArrayList<>());
    }
    collectUses();
    choosePlaced();
    given = collectGiven();
    angles = collectAngles();
    for (int section = 0; section < sections.size(); section++) {
      placedIn.add(collectPlaced(section));
    }
  }

  private void collectUses() {
    for (int s = 0; s < sections.size(); s++) {
      int section = s;
      sections.get(s).outputs().forEach(output -> use(output.value(), section));
      for (Program.Guard guard : sections.get(s).guards()) {
        use(guard.pivot(), s);
        use(guard.bound(), s);
      }
    }
    for (int id = live.length - 1; id >= 0; id--) {
      Scalar node = program.expressions().node(id);
      if (live[id] > 0 && isComputed(node)) {
        int section = sectionOf(node);
        node.operands().forEach(operand -> use(operand, section));
      }
    }
  }

  private void use(Scalar node, int section) {
    if (node.operation() == Operation.NEGATE) {
      use(node.first(), section);
    } else {
      usedIn.get(node.id()).add(section);
    }
  }

  private void choosePlaced() {
    for (int id = 0; id < live.length; id++) {
      Scalar node = program.expressions().node(id);
      int terms = 0;
      for (Scalar operand : node.operands()) {
        terms += length[operand.id()];
      }
      if (live[id] > 0 && isComputed(node)) {
        List<Integer> sectionsOfUse = usedIn.get(id);
        boolean here = sectionsOfUse.size() == 1 && sectionsOfUse.get(0) == sectionOf(node);
        placed[id] = !here || terms > LONGEST_EXPRESSION;
      }
      length[id] = placed[id] || terms == 0 || isAngleFunction(node) ? 1 : terms;
    }
  }

  /** Returns whether a node is computed in a section: it is not given, nor a change of sign. */
  static boolean isComputed(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT, INPUT, NEGATE, SINE, COSINE -> false;
      default -> true;
    };
  }

  static boolean isAngleFunction(Scalar node) {
    return node.operation() == Operation.SINE || node.operation() == Operation.COSINE;
  }

  /** Returns the section in which a node arose. */
  int sectionOf(Scalar node) {
    int low = 0;
    int high = sections.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (sections.get(middle).firstNode() <= node.id()) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }

  /** Returns the sections that use a node, one entry for every use. */
  List<Integer> sectionsUsing(Scalar node) {
    return usedIn.get(node.id());
  }

  /** Returns whether a value gets a place of its own. */
  boolean isPlaced(Scalar node) {
    return placed[node.id()];
  }

  /** Returns the values of a section that get a place, in the order of their computation. */
  List<Scalar> placedIn(int section) {
    return placedIn.get(section);
  }

  private List<Scalar> collectPlaced(int section) {
    int first = sections.get(section).firstNode();
    int last = section + 1 < sections.size() ? sections.get(section + 1).firstNode() : live.length;
    List<Scalar> nodes = new ArrayList<>();
    // What arose before the first section opened is computed in it.
    for (int id = section == 0 ? 0 : first; id < last; id++) {
      if (placed[id]) {
        nodes.add(program.expressions().node(id));
      }
    }
    return nodes;
  }

  /** Returns inputs, sines and cosines that sections use, in order of their nodes. */
  List<Scalar> given() {
    return given;
  }

  private List<Scalar> collectGiven() {
    List<Scalar> nodes = new ArrayList<>();
    for (int id = 0; id < live.length; id++) {
      Scalar node = program.expressions().node(id);
      boolean given = node.operation() == Operation.INPUT || isAngleFunction(node);
      if (live[id] > 0 && given && !usedIn.get(id).isEmpty()) {
        nodes.add(node);
      }
    }
    return nodes;
  }

  /** Returns the angles whose sines or cosines are used: first the inputs in order, then others. */
  List<Scalar> angles() {
    return angles;
  }

  private List<Scalar> collectAngles() {
    Set<Scalar> angles = new LinkedHashSet<>();
    given().stream().filter(Usage::isAngleFunction).forEach(node -> angles.add(node.first()));
    return angles.stream()
        .sorted(
            Comparator.comparing((Scalar angle) -> angle.operation() != Operation.INPUT)
                .thenComparing(Scalar::index)
                .thenComparing(Scalar::id))
        .toList();
  }
}
