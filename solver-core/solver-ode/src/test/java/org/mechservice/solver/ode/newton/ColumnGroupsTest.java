package org.mechservice.solver.ode.newton;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.linear.BandLayout;
import org.mechservice.solver.linear.DenseLayout;
import org.mechservice.solver.linear.MatrixLayout;
import org.mechservice.solver.ode.OdeSystem;
import org.mechservice.solver.ode.SparseSystem;
import org.mechservice.solver.ode.SystemParts;
import org.mechservice.solver.ode.suite.FunctionOde;

class ColumnGroupsTest {
  private static List<List<Integer>> groups(SystemParts system, MatrixLayout layout) {
    ColumnGroups groups = ColumnGroups.of(system, layout);
    List<List<Integer>> columns = new ArrayList<>();
    for (int group = 0; group < groups.count(); group++) {
      List<Integer> members = new ArrayList<>();
      for (int j = groups.first(group); j >= 0; j = groups.next(j)) {
        members.add(j);
      }
      columns.add(members);
    }
    return columns;
  }

  private static List<List<Integer>> groups(int n, SparseSystem pattern) {
    return groups(declaring(pattern), new DenseLayout(n));
  }

  private static SystemParts declaring(SparseSystem pattern) {
    return new SystemParts() {
      @Override
      public <T> Optional<T> part(Class<T> kind) {
        return kind.isInstance(pattern) ? Optional.of(kind.cast(pattern)) : Optional.empty();
      }
    };
  }

  private static boolean shareARow(SparseSystem pattern, int n, int column1, int column2) {
    for (int i = 0; i < n; i++) {
      if (pattern.couples(i, column1) && pattern.couples(i, column2)) {
        return true;
      }
    }
    return false;
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6, 7, 8})
  void columnsOfAGroupShareNoRow(int seed) {
    Random random = new Random(seed);
    int n = 5 * seed;
    boolean[][] coupled = new boolean[n][n];
    for (int i = 0; i < 3 * n; i++) {
      coupled[random.nextInt(n)][random.nextInt(n)] = true;
    }
    SparseSystem pattern = (i, j) -> coupled[i][j];
    List<List<Integer>> groups = groups(n, pattern);
    assertThat(groups.stream().mapToInt(List::size).sum()).isEqualTo(n);
    for (List<Integer> group : groups) {
      for (int j : group) {
        assertThat(group).noneMatch(l -> l != j && shareARow(pattern, n, l, j));
      }
    }
  }

  /** Curtis, Powell and Reid: a group takes every column left that shares no row with it. */
  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 4, 5, 6})
  void groupsAreThoseFilledOneAfterTheOther(int seed) {
    Random random = new Random(seed);
    int n = 10 * seed;
    boolean[][] coupled = new boolean[n][n];
    for (int i = 0; i < 3 * n; i++) {
      coupled[random.nextInt(n)][random.nextInt(n)] = true;
    }
    SparseSystem pattern = (i, j) -> coupled[i][j];
    List<Integer> left = new ArrayList<>(IntStream.range(0, n).boxed().toList());
    List<List<Integer>> expected = new ArrayList<>();
    while (!left.isEmpty()) {
      List<Integer> group = new ArrayList<>();
      for (int j : left) {
        if (group.stream().noneMatch(l -> shareARow(pattern, n, l, j))) {
          group.add(j);
        }
      }
      left.removeAll(group);
      expected.add(group);
    }
    assertThat(groups(n, pattern)).isEqualTo(expected);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3})
  void everyColumnIsInOneGroup(int seed) {
    Random random = new Random(seed);
    boolean[][] coupled = new boolean[30][30];
    for (boolean[] row : coupled) {
      row[random.nextInt(30)] = true;
      row[random.nextInt(30)] = true;
    }
    List<Integer> all = new ArrayList<>();
    groups(30, (i, j) -> coupled[i][j]).forEach(all::addAll);
    assertThat(all).hasSize(30).doesNotHaveDuplicates();
  }

  @ParameterizedTest
  @CsvSource({"1, 0, 0", "9, 0, 0", "9, 1, 1", "20, 2, 3", "12, 4, 0"})
  void patternOfABandIsGroupedAsTheBand(int n, int lower, int upper) {
    SparseSystem pattern = (i, j) -> j - i >= -lower && j - i <= upper;
    OdeSystem band = new FunctionOde(n, (t, y, yDot) -> {});
    assertThat(groups(n, pattern)).isEqualTo(groups(band, new BandLayout(n, lower, upper)));
  }

  @Test
  void columnsOfAFullMatrixStandAlone() {
    assertThat(groups(new FunctionOde(3, (t, y, yDot) -> {}), new DenseLayout(3)))
        .containsExactly(List.of(0), List.of(1), List.of(2));
  }

  @Test
  void columnThatAllRowsHaveStandsAlone() {
    assertThat(groups(5, (i, j) -> i == j || j == 2))
        .containsExactly(List.of(0, 1, 3, 4), List.of(2));
  }

  @Test
  void columnsThatNoRowHasAreOneGroup() {
    assertThat(groups(3, (i, j) -> false)).containsExactly(List.of(0, 1, 2));
  }

  @Test
  void noColumnsAreNoGroups() {
    assertThat(groups(0, (i, j) -> true)).isEmpty();
  }
}
