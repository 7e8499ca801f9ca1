package org.mechservice.solver.symbol;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A straight-line program from inputs to outputs: no branches, divided into sections, with the
 * names that values have in mechanics.
 *
 * <p>A class that derives equations opens a section, computes with {@link Scalar}s, names values
 * that have a meaning, and declares outputs. The program contains only values that outputs depend
 * on.
 */
public final class Program {
  /** The input that is the time, s. Other inputs count from 0. */
  public static final int TIME = Integer.MAX_VALUE;

  /**
   * A part of the program.
   *
   * @param title what it computes, with the equation; several lines are separated by line feeds
   * @param subject short name of its subject; part of the names of values without a name
   * @param firstNode first node made in it
   * @param outputs its outputs, in order
   * @param guards its checks, in order
   * @param readsAnew whether its code loads operands again that earlier code of the same method has
   *     loaded
   */
  public record Section(
      String title,
      String subject,
      int firstNode,
      List<Output> outputs,
      List<Guard> guards,
      boolean readsAnew) {
    /** Returns the section without its outputs. */
    public Section withoutOutputs() {
      return new Section(title, subject, firstNode, new ArrayList<>(), guards, readsAnew);
    }
  }

  /**
   * An output.
   *
   * @param index index of the output
   * @param value its value
   */
  public record Output(int index, Scalar value) {}

  /**
   * Ends the program with {@code result} where {@code pivot ≤ bound}.
   *
   * @param pivot value that must be above the bound
   * @param bound largest value that fails
   * @param result what the program then returns
   * @param meaning explanation of the failure, for readers
   */
  public record Guard(Scalar pivot, Scalar bound, int result, String meaning) {}

  /** An input that is replaced before the program is complete. */
  public static final int PLACEHOLDER = TIME - 1;

  /** The input that is the first parameter of the model; others follow, SI units. */
  public static final int PARAMETER = 1 << 29;

  private final Expressions expressions;
  private final List<Section> sections;
  private final Map<Scalar, String> names;

  /** Cached until the program changes. */
  private int[] uses = {};

  public Program() {
    this(new Expressions(), new ArrayList<>(), new HashMap<>());
  }

  private Program(Expressions expressions, List<Section> sections, Map<Scalar, String> names) {
    this.expressions = expressions;
    this.sections = sections;
    this.names = names;
  }

  /** Returns the same values in other sections. */
  public Program in(List<Section> otherSections) {
    return new Program(expressions, new ArrayList<>(otherSections), names);
  }

  /** Returns the graph of its values. */
  public Expressions expressions() {
    return expressions;
  }

  /** Opens a section. */
  public void section(String title, String subject) {
    open(title, subject, false);
  }

  /**
   * Opens one of many equal sections, whose code loads its operands again. The compiler of the
   * virtual machine cannot move such reads before the outputs of the previous section. It therefore
   * does not interleave sections, which would need more registers than there are.
   */
  public void step(String title, String subject) {
    open(title, subject, true);
  }

  private void open(String title, String subject, boolean readsAnew) {
    sections.add(
        new Section(
            title, subject, expressions.size(), new ArrayList<>(), new ArrayList<>(), readsAnew));
  }

  /**
   * Names a value, unless it has a name already, and returns it. Constants get no name; for a
   * negation the operand gets the name.
   */
  public Scalar named(String name, Scalar value) {
    if (value.operation() == ScalarOperation.NEGATE) {
      named("minus_" + name, value.first());
    } else if (!value.isNumber()) {
      names.putIfAbsent(value, name);
    }
    return value;
  }

  /** Names the components of a vector {@code name_x}, {@code name_y}, {@code name_z}. */
  public ScalarVector named(String name, ScalarVector value) {
    for (int i = 0; i < 3; i++) {
      named(name + "_" + "xyz".charAt(i), value.at(i));
    }
    return value;
  }

  /** Names the elements of a matrix {@code name_xx}, {@code name_xy} and so on. */
  public ScalarMatrix named(String name, ScalarMatrix value) {
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        named(name + "_" + "xyz".charAt(i) + "xyz".charAt(j), value.at(i, j));
      }
    }
    return value;
  }

  /** Adds an output to the current section. */
  public void output(int index, Scalar value) {
    current().outputs().add(new Output(index, value));
  }

  /** Adds a check to the current section. */
  public void guard(Guard guard) {
    current().guards().add(guard);
  }

  private Section current() {
    uses = new int[0];
    return sections.get(sections.size() - 1);
  }

  /** Returns the sections in order, a view. */
  public List<Section> sections() {
    return Collections.unmodifiableList(sections);
  }

  /** Returns whether it puts anything out. */
  public boolean hasOutputs() {
    return sections.stream().anyMatch(section -> !section.outputs().isEmpty());
  }

  /** Returns the name of a value, if it has one. */
  public Optional<String> nameOf(Scalar value) {
    return Optional.ofNullable(names.get(value));
  }

  /**
   * Returns the number of uses of each node, by node number; 0 if the program does not contain it.
   * Must not be modified.
   */
  public int[] uses() {
    int[] known = uses;
    if (known.length < expressions.size()) {
      known = countedUses();
      uses = known;
    }
    return known;
  }

  private int[] countedUses() {
    int[] counts = new int[expressions.size()];
    for (Section section : sections) {
      for (Output output : section.outputs()) {
        counts[output.value().id()]++;
      }
      for (Guard guard : section.guards()) {
        counts[guard.pivot().id()]++;
        counts[guard.bound().id()]++;
      }
    }
    for (int id = counts.length - 1; id >= 0; id--) {
      if (counts[id] > 0) {
        List<Scalar> operands = expressions.node(id).operands();
        for (int i = 0; i < operands.size(); i++) {
          counts[operands.get(i).id()]++;
        }
      }
    }
    return counts;
  }

  /** Returns the additions, multiplications, divisions and square roots of one run. */
  public int operationCount() {
    int[] uses = uses();
    int count = 0;
    for (int id = 0; id < uses.length; id++) {
      count += uses[id] > 0 ? expressions.node(id).operation().flops() : 0;
    }
    return count;
  }

  /**
   * Runs the program in doubles at time 0.
   *
   * @param inputs by index; not modified
   * @param outputs by index; overwritten where the program puts something out
   * @return the result of the first guard that fails; −1 if none does
   */
  public int evaluate(double[] inputs, double[] outputs) {
    return evaluate(0, inputs, outputs);
  }

  /**
   * Runs the program in doubles at a time.
   *
   * @param time s
   * @param inputs the others, by index; not modified
   * @param outputs by index; overwritten where the program puts something out
   * @return the result of the first guard that fails; −1 if none does
   */
  public int evaluate(double time, double[] inputs, double[] outputs) {
    return new ProgramEvaluation(this).run(time, inputs, outputs);
  }
}
