package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The uses of the values of a program, and the choice of values that get a variable.
 *
 * <p>A value is computed in the section in which it was recorded. A value with a single use in that
 * section is written out at its use; a change of sign always is. Sines and cosines come before all
 * sections.
 */
public final class ValueUsage {
  /** Largest number of operations of one expression; a longer one is divided for readability. */
  private static final int LONGEST_EXPRESSION = 14;

  private static final Comparator<Scalar> ANGLES = new AngleOrder();

  private final Program program;
  private final List<Program.Section> sections;
  private final int[] live;
  private final int[] sectionOf;

  /**
   * Uses of node i: elements firstUse[i] to firstUse[i + 1] of {@link #users}, one section each.
   */
  private final int[] firstUse;

  private int[] users = {};
  private final boolean[] placed;
  private final List<List<Scalar>> placedIn = new ArrayList<>();
  private final List<Scalar> given;
  private final List<Scalar> angles;

  public ValueUsage(Program program) {
    this.program = program;
    this.sections = program.sections();
    this.live = program.uses();
    this.sectionOf = sectionsOfNodes();
    this.placed = new boolean[live.length];
    this.firstUse = new int[live.length + 1];
    collectUses();
    choosePlaced();
    given = collectGiven();
    angles = collectAngles();
    collectPlaced();
  }

  /** Returns the section of each node; nodes recorded before the first section belong to it. */
  private int[] sectionsOfNodes() {
    int[] sectionOfNode = new int[live.length];
    int section = 0;
    for (int id = 0; id < live.length; id++) {
      while (section + 1 < sections.size() && sections.get(section + 1).firstNode() <= id) {
        section++;
      }
      sectionOfNode[id] = section;
    }
    return sectionOfNode;
  }

  /** Collects the uses in two passes: the first counts, the second stores. */
  private void collectUses() {
    eachUse((node, section) -> firstUse[node + 1]++);
    for (int id = 0; id < live.length; id++) {
      firstUse[id + 1] += firstUse[id];
    }
    users = new int[firstUse[live.length]];
    int[] next = firstUse.clone();
    eachUse((node, section) -> users[next[node]++] = section);
  }

  /** Receives the use of a node in a section. */
  private interface UseListener {
    void used(int node, int section);
  }

  private void eachUse(UseListener listener) {
    for (int s = 0; s < sections.size(); s++) {
      for (Program.Output output : sections.get(s).outputs()) {
        use(output.value(), s, listener);
      }
      for (Program.Guard guard : sections.get(s).guards()) {
        use(guard.pivot(), s, listener);
        use(guard.bound(), s, listener);
      }
    }
    for (int id = live.length - 1; id >= 0; id--) {
      Scalar node = program.expressions().node(id);
      if (live[id] > 0 && isComputed(node)) {
        List<Scalar> operands = node.operands();
        for (int i = 0; i < operands.size(); i++) {
          use(operands.get(i), sectionOf[id], listener);
        }
      }
    }
  }

  private static void use(Scalar node, int section, UseListener listener) {
    Scalar used = node.operation() == ScalarOperation.NEGATE ? node.first() : node;
    listener.used(used.id(), section);
  }

  private void choosePlaced() {
    int[] length = new int[live.length];
    for (int id = 0; id < live.length; id++) {
      Scalar node = program.expressions().node(id);
      int terms = 0;
      List<Scalar> operands = node.operands();
      for (int i = 0; i < operands.size(); i++) {
        terms += length[operands.get(i).id()];
      }
      if (live[id] > 0 && isComputed(node)) {
        boolean here = useCount(id) == 1 && users[firstUse[id]] == sectionOf[id];
        placed[id] = !here || terms > LONGEST_EXPRESSION;
      }
      length[id] = placed[id] || terms == 0 || isAngleFunction(node) ? 1 : terms;
    }
  }

  private int useCount(int id) {
    return firstUse[id + 1] - firstUse[id];
  }

  /**
   * Returns whether a node is computed in a section: it is neither an input nor a change of sign.
   */
  public static boolean isComputed(Scalar node) {
    return switch (node.operation()) {
      case CONSTANT, INPUT, NEGATE, SINE, COSINE -> false;
      default -> true;
    };
  }

  public static boolean isAngleFunction(Scalar node) {
    return node.operation() == ScalarOperation.SINE || node.operation() == ScalarOperation.COSINE;
  }

  /** Returns the number of uses of a value. */
  public int useCount(Scalar node) {
    return useCount(node.id());
  }

  /** Returns the section of use {@code i} of a node. */
  public int user(Scalar node, int i) {
    return users[firstUse[node.id()] + i];
  }

  /** Returns whether a value gets a variable. */
  boolean isPlaced(Scalar node) {
    return placed[node.id()];
  }

  /** Returns the values of a section that get a variable, in the order of their computation. */
  public List<Scalar> placedIn(int section) {
    return placedIn.get(section);
  }

  private void collectPlaced() {
    for (int section = 0; section < sections.size(); section++) {
      placedIn.add(new ArrayList<>());
    }
    for (int id = 0; id < live.length; id++) {
      if (placed[id]) {
        placedIn.get(sectionOf[id]).add(program.expressions().node(id));
      }
    }
  }

  /** Returns inputs, sines and cosines that sections use, in order of their nodes. */
  public List<Scalar> given() {
    return given;
  }

  private List<Scalar> collectGiven() {
    List<Scalar> nodes = new ArrayList<>();
    for (int id = 0; id < live.length; id++) {
      Scalar node = program.expressions().node(id);
      boolean isGiven = node.operation() == ScalarOperation.INPUT || isAngleFunction(node);
      if (live[id] > 0 && isGiven && useCount(id) > 0) {
        nodes.add(node);
      }
    }
    return nodes;
  }

  /** Returns the angles whose sines or cosines are used: first the inputs in order, then others. */
  public List<Scalar> angles() {
    return angles;
  }

  private List<Scalar> collectAngles() {
    Set<Scalar> found = new LinkedHashSet<>();
    for (Scalar node : given) {
      if (isAngleFunction(node)) {
        found.add(node.first());
      }
    }
    List<Scalar> sorted = new ArrayList<>(found);
    sorted.sort(ANGLES);
    return sorted;
  }

  /** Inputs before others, in order of input and then of node. */
  private static final class AngleOrder implements Comparator<Scalar> {
    @Override
    public int compare(Scalar a, Scalar b) {
      if (a.operation() == ScalarOperation.INPUT ^ b.operation() == ScalarOperation.INPUT) {
        return a.operation() == ScalarOperation.INPUT ? -1 : 1;
      }
      return a.index() != b.index()
          ? Integer.compare(a.index(), b.index())
          : Integer.compare(a.id(), b.id());
    }
  }
}
