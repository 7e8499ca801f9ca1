package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.mechservice.solver.spatial.NumberTable;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.NumberRow;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarOperation;

/**
 * The numbers of a class that are no literals: the numbers of links and the constants in which
 * calls of one method differ, and the rows that programs search, each once.
 */
public final class ConstantTable {
  /** The class of the solver that reads the table from its texts. */
  public static final Class<?> READER = NumberTable.class;

  /** Name of the table inside methods. */
  public static final String NAME = "c";

  /** Name of the field that holds the table. */
  public static final String FIELD = "CONSTANTS";

  /** Characters of a text: a class file holds up to 65535 bytes in one. */
  private static final int LONGEST_TEXT = 16_000;

  private final List<Double> numbers = new ArrayList<>();
  private final Map<NumberRow, Integer> rows = new HashMap<>();

  /** Where the numbers of graphs begin. */
  private final IdentityHashMap<Expressions, Integer> graphs = new IdentityHashMap<>();

  /** Appends numbers and returns where the first of them is. */
  public int add(List<Double> row) {
    numbers.addAll(row);
    return numbers.size() - row.size();
  }

  /** Appends the rows that a program reads and that are not here yet. */
  public void addRows(Program program) {
    int[] uses = program.uses();
    for (int id = 0; id < uses.length; id++) {
      Scalar node = program.expressions().node(id);
      if (uses[id] > 0
          && node.operation() == ScalarOperation.FUNCTION
          && node.function().readsRow()) {
        rows.computeIfAbsent(node.row(), this::append);
      }
    }
  }

  private int append(NumberRow row) {
    for (int i = 0; i < row.size(); i++) {
      numbers.add(row.at(i));
    }
    return numbers.size() - row.size();
  }

  /**
   * Appends the {@linkplain Expressions#number numbers} of a graph, unless they are here already,
   * and returns where the first of them is.
   */
  public int addNumbers(Expressions graph) {
    return graphs.computeIfAbsent(graph, key -> add(key.numbers()));
  }

  /** Returns where the first number of a row is. */
  public int placeOf(NumberRow row) {
    return Objects.requireNonNull(rows.get(row), "a row that was not added");
  }

  /** Removes the constants added beyond a size, which no row is. */
  public void cutBack(int size) {
    numbers.subList(size, numbers.size()).clear();
    graphs.values().removeIf(start -> start >= size);
  }

  public boolean isEmpty() {
    return numbers.isEmpty();
  }

  public int size() {
    return numbers.size();
  }

  /**
   * Returns the numbers as decimals separated by blanks, in texts that a class file can hold.
   * {@link #READER} turns them into an array.
   */
  public List<String> texts() {
    List<String> texts = new ArrayList<>();
    NumberText decimals = new NumberText();
    StringBuilder text = new StringBuilder();
    for (double number : numbers) {
      if (text.length() > LONGEST_TEXT) {
        texts.add(text.toString());
        text.setLength(0);
      }
      text.append(decimals.of(number)).append(' ');
    }
    texts.add(text.toString());
    return texts;
  }
}
