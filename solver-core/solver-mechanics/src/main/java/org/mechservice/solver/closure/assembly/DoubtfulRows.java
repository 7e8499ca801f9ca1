package org.mechservice.solver.closure.assembly;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.stream.IntStream;
import org.mechservice.solver.linear.PivotedElimination;
import org.mechservice.solver.linear.SparseElimination;
import org.mechservice.solver.linear.spectrum.SingularValues;

/**
 * Rows that sparse elimination left without a clear pivot, as a dense matrix: those that are
 * coupled by columns with each other and with no others. A row without elements is a group of its
 * own.
 */
final class DoubtfulRows {
  private final int[] names;
  private final int width;

  /** The remaining elements of the rows, without columns of zeros. */
  private final double[] left;

  private final double[] values;
  private int taken;
  private List<Integer> redundant = List.of();

  private DoubtfulRows(SparseElimination elimination, int[] steps) {
    names = Arrays.stream(steps).map(elimination::row).toArray();
    Map<Integer, Integer> place = new LinkedHashMap<>();
    for (int k : steps) {
      for (int j : elimination.columnsLeft(k)) {
        place.putIfAbsent(j, place.size());
      }
    }
    width = place.size();
    left = new double[names.length * width];
    for (int i = 0; i < steps.length; i++) {
      int[] columns = elimination.columnsLeft(steps[i]);
      double[] elements = elimination.elementsLeft(steps[i]);
      for (int e = 0; e < columns.length; e++) {
        int at = Objects.requireNonNull(place.get(columns[e]), "column of no row");
        left[i * width + at] = elements[e];
      }
    }
    SingularValues singular = new SingularValues(names.length, width);
    singular.decompose(left);
    values =
        IntStream.range(0, Math.min(names.length, width)).mapToDouble(singular::value).toArray();
  }

  /**
   * Returns the groups of the rows without pivots.
   *
   * @param first index of the first row without pivot in {@link SparseElimination#row}
   * @param count how many
   * @param columns number of columns of the matrix
   */
  static List<DoubtfulRows> groups(
      SparseElimination elimination, int first, int count, int columns) {
    int[] of = IntStream.range(0, count).toArray();
    int[] rowOfColumn = new int[columns];
    Arrays.fill(rowOfColumn, -1);
    for (int i = 0; i < count; i++) {
      for (int j : elimination.columnsLeft(first + i)) {
        if (rowOfColumn[j] < 0) {
          rowOfColumn[j] = i;
        } else {
          of[head(of, i)] = head(of, rowOfColumn[j]);
        }
      }
    }
    Map<Integer, List<Integer>> members = new LinkedHashMap<>();
    for (int i = 0; i < count; i++) {
      members.computeIfAbsent(head(of, i), key -> new ArrayList<>()).add(first + i);
    }
    return members.values().stream()
        .map(rows -> rows.stream().mapToInt(Integer::intValue).toArray())
        .map(rows -> new DoubtfulRows(elimination, rows))
        .toList();
  }

  /** Returns the row that stands for the group of a row so far; ways to it are shortened. */
  private static int head(int[] of, int row) {
    int i = row;
    while (of[i] != i) {
      of[i] = of[of[i]];
      i = of[i];
    }
    return i;
  }

  /** Returns the singular values, largest first, as many as there are rows or columns. */
  double[] values() {
    return values;
  }

  /** Counts one more of the rows as independent. */
  void take() {
    taken++;
  }

  /**
   * Chooses the independent rows, as many as were taken.
   *
   * @return the smallest pivot, infinite if none is independent
   */
  double choose() {
    PivotedElimination among = new PivotedElimination(names.length, width);
    int found = among.eliminate(left, taken);
    redundant = IntStream.range(found, names.length).mapToObj(i -> names[among.row(i)]).toList();
    return found == 0 ? Double.POSITIVE_INFINITY : among.pivot(found - 1);
  }

  /** Returns the rows that are not independent, after {@link #choose}. */
  List<Integer> redundant() {
    return redundant;
  }
}
