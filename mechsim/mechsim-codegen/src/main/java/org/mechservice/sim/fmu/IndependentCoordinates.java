package org.mechservice.sim.fmu;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntPredicate;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.mechservice.sim.emit.c.CArrays;
import org.mechservice.sim.emit.c.CLoops;
import org.mechservice.sim.emit.c.CModel;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.kinematics.StateCoordinates;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.linear.SparseMatrix;
import org.mechservice.solver.text.ShortestDecimal;

/**
 * Coordinates of a mechanism with closed loops that determine all others near the start. They are
 * chosen by J, with rows per size and columns in units: the columns of the others, the longest
 * orthogonal rest first, must span all of it. The three velocities of a ball are taken or left
 * together, since its Euler parameters are no coordinates one by one.
 */
final class IndependentCoordinates {
  /** Smallest pivot relative to the largest of coordinates that the others determine. */
  private static final double DETERMINED = 1e-6;

  /** Part of the longest rest from which another counts as good. */
  private static final double NEARLY_BEST = 0.1;

  private final CModel model;
  private final StateCoordinates coordinates;
  private final CLoops loops;
  private final int velocities;

  /** For each velocity the name of its position; of a ball's velocities that of its joint. */
  private final List<String> names = new ArrayList<>();

  private final List<String> joints = new ArrayList<>();
  private final boolean[] given;

  /**
   * @param wanted names of positions or joints; none to choose them here
   * @throws IllegalArgumentException if the model has no such coordinates, or they do not determine
   *     the others; the message says which do
   */
  IndependentCoordinates(CModel model, CLoops loops, List<String> wanted) {
    this.model = model;
    this.loops = loops;
    this.coordinates = new StateCoordinates(model.mechanism());
    this.velocities = coordinates.velocityCount();
    for (JointVariables joint : model.description().joints()) {
      joints.addAll(Collections.nCopies(joint.type().velocityCount(), joint.name()));
    }
    for (int k = 0; k < velocities; k++) {
      int position = coordinates.positionOf(k);
      names.add(position < 0 ? joints.get(k) : model.states().get(position).name());
    }
    if (!loops.isHolonomic()) {
      throw new IllegalArgumentException(
          "--coordinates independent: model \""
              + model.modelName()
              + "\" rolls or has edges that do not slip, and has more independent positions than"
              + " velocities; leave the option out: the state is then moved onto the constraints");
    }
    boolean[] chosen = chosen();
    given = wanted.isEmpty() ? chosen : wanted(wanted, chosen);
  }

  private boolean[] wanted(List<String> wanted, boolean[] chosen) {
    boolean[] marks = new boolean[velocities];
    for (String name : wanted) {
      int[] found =
          IntStream.range(0, velocities)
              .filter(k -> names.get(k).equals(name) || joints.get(k).equals(name))
              .toArray();
      if (found.length == 0) {
        throw new IllegalArgumentException(
            "--coordinates independent:"
                + name
                + ": no joint and no position has this name; the positions are "
                + list(k -> true));
      }
      Arrays.stream(found).forEach(k -> marks[k] = true);
    }
    int count = (int) IntStream.range(0, velocities).filter(k -> marks[k]).count();
    int freedom = velocities - loops.rank();
    if (count != freedom) {
      throw new IllegalArgumentException(
          "--coordinates independent:"
              + String.join(",", wanted)
              + ": these are "
              + count
              + " coordinates, but the mechanism has "
              + freedom
              + " degrees of freedom; such as "
              + list(k -> chosen[k]));
    }
    Elimination elimination = new Elimination(columns());
    int found = elimination.take(k -> !marks[k]);
    if (found != loops.rank()) {
      throw new IllegalArgumentException(
          "--coordinates independent:"
              + String.join(",", wanted)
              + ": at the start these do not determine the other coordinates; such as "
              + list(k -> chosen[k])
              + " do");
    }
    return marks;
  }

  private String list(IntPredicate which) {
    return IntStream.range(0, velocities)
        .filter(which)
        .mapToObj(names::get)
        .distinct()
        .collect(Collectors.joining(","));
  }

  /** Returns marks of velocities that determine the others at the start. */
  private boolean[] chosen() {
    boolean[] marks = new boolean[velocities];
    Arrays.fill(marks, true);
    Elimination elimination = new Elimination(columns());
    int others = 0;
    for (int b = 0; b < coordinates.ballCount(); b++) {
      int first = coordinates.ballVelocity(b);
      Elimination before = elimination.copy();
      if (elimination.take(k -> k >= first && k < first + 3) == 3) {
        Arrays.fill(marks, first, first + 3, false);
        others += 3;
      } else {
        elimination = before;
      }
    }
    others += elimination.take(k -> marks[k] && coordinates.positionOf(k) >= 0, marks);
    if (others != loops.rank()) {
      throw new IllegalArgumentException(
          "--coordinates independent: at the start of model \""
              + model.modelName()
              + "\" no coordinates determine all others, as in a singular position or where a ball"
              + " moves in part; leave the option out: the state is then moved onto the loops");
    }
    return marks;
  }

  /** Returns the columns of J at the start. */
  private double[][] columns() {
    double[] start = model.states().stream().mapToDouble(state -> state.start()).toArray();
    double t = model.description().defaults().tStart();
    TreeGeometry tree = new TreeGeometry(model.mechanism());
    TreeMotion motion = new TreeMotion(tree);
    LoopEquations equations = new LoopEquations(tree);
    motion.sweep(t, start);
    equations.place(motion, t);
    equations.differentiate(motion);
    double[][] columns = new double[velocities][equations.count()];
    SparseMatrix jacobian = equations.jacobian;
    for (int row = 0; row < equations.count(); row++) {
      for (int e = jacobian.start[row]; e < jacobian.start[row + 1]; e++) {
        int k = jacobian.column[e];
        if (k < velocities) {
          columns[k][row] = jacobian.value[e] / equations.size(row) * loops.unit().get(k);
        }
      }
    }
    return columns;
  }

  /** Columns of which some are taken, the rests of the others orthogonal to them. */
  private static final class Elimination {
    private final double[][] columns;
    private final double largest;

    Elimination(double[][] columns) {
      this(columns, Arrays.stream(columns).mapToDouble(Elimination::length).max().orElse(0));
    }

    private Elimination(double[][] columns, double largest) {
      this.columns = columns;
      this.largest = largest;
    }

    Elimination copy() {
      return new Elimination(
          Arrays.stream(columns).map(double[]::clone).toArray(double[][]::new), largest);
    }

    private static double length(double[] column) {
      return Math.sqrt(Arrays.stream(column).map(x -> x * x).sum());
    }

    int take(IntPredicate group) {
      return take(group, new boolean[columns.length]);
    }

    /**
     * Takes the columns of a group, the longest rest first, until what is left is zero. Of rests
     * that are nearly as long the last is taken, so that joints near the base, such as cranks, are
     * left.
     *
     * @param left marks of columns that are not taken; those taken are cleared
     * @return the number taken
     */
    int take(IntPredicate group, boolean[] left) {
      boolean[] belongs = new boolean[columns.length];
      for (int k = 0; k < columns.length; k++) {
        belongs[k] = group.test(k);
      }
      for (int taken = 0; ; taken++) {
        int next = -1;
        double most = DETERMINED * largest;
        for (int k = 0; k < columns.length; k++) {
          most = belongs[k] ? Math.max(most, length(columns[k])) : most;
        }
        double length = 0;
        for (int k = 0; k < columns.length; k++) {
          double own = length(columns[k]);
          if (belongs[k] && own > DETERMINED * largest && own >= NEARLY_BEST * most) {
            length = own;
            next = k;
          }
        }
        if (next < 0) {
          return taken;
        }
        belongs[next] = false;
        left[next] = false;
        double size = length;
        double[] unit = Arrays.stream(columns[next]).map(x -> x / size).toArray();
        for (int k = 0; k < columns.length; k++) {
          subtract(columns[k], unit);
        }
      }
    }

    private static void subtract(double[] column, double[] unit) {
      double dot = 0;
      for (int i = 0; i < unit.length; i++) {
        dot += column[i] * unit[i];
      }
      for (int i = 0; i < unit.length; i++) {
        column[i] -= dot * unit[i];
      }
    }
  }

  /** Returns the indices of the states that remain, in order. */
  List<Integer> states() {
    return IntStream.range(0, model.states().size()).filter(this::remains).boxed().toList();
  }

  /** Returns the indices of the other coordinates and velocities. */
  List<Integer> others() {
    return IntStream.range(0, model.states().size()).filter(i -> !remains(i)).boxed().toList();
  }

  private boolean remains(int state) {
    int positions = coordinates.positionCount();
    if (state >= positions + velocities) {
      return true;
    }
    if (state >= positions) {
      return given[state - positions];
    }
    if (coordinates.velocityOf(state) >= 0) {
      return given[coordinates.velocityOf(state)];
    }
    for (int b = 0; b < coordinates.ballCount(); b++) {
      int first = coordinates.ballPosition(b);
      if (state >= first && state < first + 4) {
        return given[coordinates.ballVelocity(b)];
      }
    }
    throw new IllegalStateException("state " + state + " belongs to no joint");
  }

  private boolean hasBall() {
    return IntStream.range(0, coordinates.ballCount())
        .anyMatch(b -> given[coordinates.ballVelocity(b)]);
  }

  private static String quantitiesHead(String function) {
    return "int mech_independent_"
        + function
        + "(mech_independent_t *m, double t, const double *x, double *values)";
  }

  /**
   * Returns the header of the model in these coordinates.
   *
   * @param quantities names of the functions of quantities that steps watch
   */
  String header(String template, List<String> quantities) {
    String watched =
        quantities.stream()
            .map(function -> quantitiesHead(function) + ";\n")
            .collect(Collectors.joining());
    return template
        .replace("\n#endif\n", watched + "\n#endif\n")
        .replace("@NX@", Integer.toString(states().size()))
        .replace("@OTHERS@", Integer.toString(others().size()))
        .replace("@NV@", Integer.toString(velocities))
        .replace("MODEL", model.name());
  }

  /** Returns a constant array; one without elements gets a zero, since C has no empty arrays. */
  private static String integers(String array, List<Integer> values) {
    String elements = values.stream().map(String::valueOf).collect(Collectors.joining(", "));
    return array + "[] = {" + (values.isEmpty() ? "0" : elements) + "};\n";
  }

  /**
   * Returns a function of quantities at a place where perhaps no state is found, which is no
   * failure of the step.
   */
  private String quantities(String function) {
    return "\n"
        + quantitiesHead(function)
        + """
           {
            int lost = m->lost, failures = m->failures;
            double *y = complete(m, t, x);
            if (y == NULL) {
              m->lost = lost;
              m->failures = failures;
              m->text[0] = 0;
              return -1;
            }
            return %s_%s(&m->full, t, y, values);
          }
          """
            .formatted(model.name(), function);
  }

  /**
   * Returns the code of the model in these coordinates: the tables, then the functions.
   *
   * @param quantities names of the functions of quantities that steps watch
   */
  String source(String template, List<String> quantities) {
    StringBuilder text = new StringBuilder();
    text.append(
        "#include \"mech_independent.h\"\n\n#include <math.h>\n#include <stdio.h>\n#include <string.h>\n\n");
    text.append("/* States that remain, and the others, by their places in the whole state. */\n");
    text.append(integers("static const int STATE", states()));
    text.append(integers("static const int OTHER", others()));
    text.append(
        "/* Marks of the velocities that remain, and names of the coordinates of all. */\n");
    List<Integer> marks = new ArrayList<>();
    for (boolean mark : given) {
      marks.add(mark ? 1 : 0);
    }
    text.append(integers("static const unsigned char GIVEN", marks));
    List<String> different = names.stream().distinct().toList();
    for (int i = 0; i < different.size(); i++) {
      text.append("static const char NAME_" + i + "[] = ");
      text.append(CArrays.literal(different.get(i))).append(";\n");
    }
    text.append("static const char *const NAME[] = {");
    text.append(
        names.stream().map(n -> "NAME_" + different.indexOf(n)).collect(Collectors.joining(", ")));
    text.append("};\nstatic const char CHOSEN[] = ");
    text.append(CArrays.literal(list(k -> given[k]))).append(";\n");
    text.append("static const double UNIT[] = {");
    text.append(
        loops.unit().stream().map(ShortestDecimal::format).collect(Collectors.joining(", ")));
    text.append("};\nenum { V = " + coordinates.positionCount() + " };\n");
    text.append(
        "enum { DEPENDENT = " + loops.rank() + ", BALLS = " + (hasBall() ? 1 : 0) + " };\n");
    text.append(template.replace("MODEL", model.name()));
    quantities.forEach(function -> text.append(quantities(function)));
    return text.toString();
  }
}
