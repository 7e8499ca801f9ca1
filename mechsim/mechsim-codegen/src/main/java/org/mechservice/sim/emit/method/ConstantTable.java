package org.mechservice.sim.emit.method;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.spatial.NumberTable;

/** The constants in which calls of one method differ, packed into one table of the class. */
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

  /** Appends numbers and returns where the first of them is. */
  public int add(List<Double> row) {
    numbers.addAll(row);
    return numbers.size() - row.size();
  }

  /** Removes the constants added beyond a size. */
  public void cutBack(int size) {
    numbers.subList(size, numbers.size()).clear();
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
