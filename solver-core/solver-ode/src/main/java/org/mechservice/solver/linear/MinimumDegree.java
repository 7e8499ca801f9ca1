package org.mechservice.solver.linear;

import java.util.Arrays;

/**
 * An order of elimination that keeps the factors of a sparse matrix sparse: always a variable that
 * is coupled with about the fewest others, by the pattern of A + Aᵀ.
 *
 * <p>What an eliminated variable has coupled is kept as one element, the list of these variables,
 * and not as pairs of them: the graph never grows. The number of neighbours is bounded from above,
 * by what the elements of a variable have beside those of the last pivot. Variables that cannot be
 * told apart are eliminated as one. Variables coupled with very many others come last. Amestoy,
 * Davis and Duff, <i>An approximate minimum degree ordering algorithm</i>, SIAM J. Matrix Anal.
 * Appl. 17 (1996) 886.
 */
public final class MinimumDegree {
  private static final int NONE = -1;
  private static final int[] EMPTY = {};

  /** A variable with more neighbours than this, in units of √n, is left to the end. */
  private static final double MANY = 10;

  private static final int FEW = 16;

  private final int n;

  /** Variables that each variable is coupled with directly; elements that it is in. */
  private final int[][] neighbours;

  private final int[] neighbourCount;
  private final int[][] elements;
  private final int[] elementCount;

  /** Variables of each element, by its pivot; empty if it is none or has become part of another. */
  private final int[][] members;

  /** How many variables each stands for: 0 if it is eliminated or is part of another. */
  private final int[] weight;

  private final int[] degree;

  /** Variables that follow one in the order at once, as a chain. */
  private final int[] follower;

  private final int[] lastFollower;

  /** Lists of the variables by degree. */
  private final int[] head;

  private final int[] after;
  private final int[] before;

  /** Marks that are valid if they equal the present one. */
  private final int[] mark;

  private int marked;

  /** Weight of each element outside of the last pivot's, where its mark is valid. */
  private final int[] outside;

  private final int[] outsideMark;

  private final int[] order;
  private int placed;
  private int left;

  private MinimumDegree(SparseLayout layout) {
    n = layout.dimension();
    neighbours = new int[n][];
    neighbourCount = new int[n];
    elements = new int[n][];
    elementCount = new int[n];
    members = new int[n][];
    weight = new int[n];
    degree = new int[n];
    follower = new int[n];
    lastFollower = new int[n];
    head = new int[n + 1];
    after = new int[n];
    before = new int[n];
    mark = new int[n];
    outside = new int[n];
    outsideMark = new int[n];
    order = new int[n];
    couple(layout);
  }

  /** Returns the columns in the order in which they are to be eliminated. */
  public static int[] order(SparseLayout layout) {
    MinimumDegree search = new MinimumDegree(layout);
    search.run();
    return search.order;
  }

  /** Takes the pattern of A + Aᵀ without its diagonal; elements on both sides are there twice. */
  private void couple(SparseLayout layout) {
    for (int j = 0; j < n; j++) {
      for (int place = layout.start(j); place < layout.start(j + 1); place++) {
        int i = layout.rowAt(place);
        if (i != j) {
          neighbourCount[i]++;
          neighbourCount[j]++;
        }
      }
    }
    for (int i = 0; i < n; i++) {
      neighbours[i] = new int[neighbourCount[i]];
      neighbourCount[i] = 0;
      elements[i] = EMPTY;
      members[i] = EMPTY;
      weight[i] = 1;
      follower[i] = NONE;
      lastFollower[i] = i;
    }
    for (int j = 0; j < n; j++) {
      for (int place = layout.start(j); place < layout.start(j + 1); place++) {
        int i = layout.rowAt(place);
        if (i != j) {
          neighbours[i][neighbourCount[i]++] = j;
          neighbours[j][neighbourCount[j]++] = i;
        }
      }
    }
    for (int i = 0; i < n; i++) {
      dropRepeated(i);
    }
  }

  private void dropRepeated(int i) {
    marked++;
    int kept = 0;
    for (int k = 0; k < neighbourCount[i]; k++) {
      int other = neighbours[i][k];
      if (mark[other] != marked) {
        mark[other] = marked;
        neighbours[i][kept++] = other;
      }
    }
    neighbourCount[i] = kept;
  }

  private void run() {
    Arrays.fill(head, NONE);
    left = n;
    double most = Math.max(FEW, MANY * Math.sqrt(n));
    int[] late = new int[n];
    int lateCount = 0;
    for (int i = 0; i < n; i++) {
      if (neighbourCount[i] > most) {
        late[lateCount++] = i;
        weight[i] = 0;
        left--;
      }
    }
    for (int i = n - 1; i >= 0; i--) {
      if (weight[i] > 0) {
        degree[i] = neighbourCount[i];
        enter(i);
      }
    }
    int smallest = 0;
    while (left > 0) {
      while (head[smallest] == NONE) {
        smallest++;
      }
      smallest = eliminate(head[smallest]);
    }
    for (int k = 0; k < lateCount; k++) {
      order[placed++] = late[k];
    }
  }

  private void enter(int i) {
    int first = head[degree[i]];
    after[i] = first;
    before[i] = NONE;
    if (first != NONE) {
      before[first] = i;
    }
    head[degree[i]] = i;
  }

  private void remove(int i) {
    if (before[i] == NONE) {
      head[degree[i]] = after[i];
    } else {
      after[before[i]] = after[i];
    }
    if (after[i] != NONE) {
      before[after[i]] = before[i];
    }
  }

  private void place(int i) {
    for (int l = i; l != NONE; l = follower[l]) {
      order[placed++] = l;
    }
    left -= weight[i];
    weight[i] = 0;
  }

  /** Eliminates a variable; returns a bound from below of the degrees left. */
  private int eliminate(int pivot) {
    remove(pivot);
    int[] coupled = coupledWith(pivot);
    place(pivot);
    measureOutside(coupled);
    int total = 0;
    for (int i : coupled) {
      total += weight[i];
    }
    int lowest = n;
    for (int i : coupled) {
      remove(i);
      update(i, pivot, total);
      if (neighbourCount[i] == 0 && elementCount[i] == 1) {
        // coupled with nothing but the pivot's element: eliminated with no new coupling
        place(i);
      }
    }
    mergeAlike(coupled);
    int kept = 0;
    for (int i : coupled) {
      if (weight[i] > 0) {
        coupled[kept++] = i;
        degree[i] = Math.max(0, Math.min(degree[i], left - weight[i]));
        enter(i);
        lowest = Math.min(lowest, degree[i]);
      }
    }
    members[pivot] = kept == coupled.length ? coupled : Arrays.copyOf(coupled, kept);
    return Math.min(lowest, degree[pivot]);
  }

  /**
   * Returns the variables that a pivot is coupled with; its elements become part of the new one.
   */
  private int[] coupledWith(int pivot) {
    int size = neighbourCount[pivot];
    for (int k = 0; k < elementCount[pivot]; k++) {
      size += members[elements[pivot][k]].length;
    }
    int[] found = new int[size];
    int count = 0;
    marked++;
    mark[pivot] = marked;
    for (int k = 0; k < neighbourCount[pivot]; k++) {
      count = add(neighbours[pivot][k], found, count);
    }
    for (int k = 0; k < elementCount[pivot]; k++) {
      int element = elements[pivot][k];
      for (int i : members[element]) {
        count = add(i, found, count);
      }
      members[element] = EMPTY;
    }
    neighbours[pivot] = EMPTY;
    elements[pivot] = EMPTY;
    return count == size ? found : Arrays.copyOf(found, count);
  }

  private int add(int i, int[] found, int count) {
    if (weight[i] == 0 || mark[i] == marked) {
      return count;
    }
    mark[i] = marked;
    found[count] = i;
    return count + 1;
  }

  /** Finds for every element of the variables how much of it lies outside of them. */
  private void measureOutside(int[] coupled) {
    for (int i : coupled) {
      for (int k = 0; k < elementCount[i]; k++) {
        int element = elements[i][k];
        if (outsideMark[element] != marked) {
          outsideMark[element] = marked;
          outside[element] = weightOf(members[element]);
        }
        outside[element] -= weight[i];
      }
    }
  }

  private int weightOf(int[] variables) {
    int sum = 0;
    for (int i : variables) {
      sum += weight[i];
    }
    return sum;
  }

  /**
   * Drops what the pivot's element contains from a variable of it, and bounds its degree; the
   * variables of the element are marked.
   */
  private void update(int i, int pivot, int total) {
    int kept = 0;
    int bound = total - weight[i];
    for (int k = 0; k < neighbourCount[i]; k++) {
      int other = neighbours[i][k];
      if (weight[other] > 0 && mark[other] != marked) {
        neighbours[i][kept++] = other;
        bound += weight[other];
      }
    }
    neighbourCount[i] = kept;
    kept = 0;
    int[] of = elements[i];
    for (int k = 0; k < elementCount[i]; k++) {
      int element = of[k];
      if (members[element].length > 0 && outside[element] > 0) {
        of[kept++] = element;
        bound += outside[element];
      }
    }
    if (kept == of.length) {
      of = Arrays.copyOf(of, kept + 2);
      elements[i] = of;
    }
    of[kept++] = pivot;
    elementCount[i] = kept;
    degree[i] = Math.min(bound, degree[i] + total - weight[i]);
  }

  /** Makes one variable of those that have the same neighbours and elements. */
  private void mergeAlike(int[] coupled) {
    long[] keys = new long[coupled.length];
    int count = 0;
    for (int k = 0; k < coupled.length; k++) {
      if (weight[coupled[k]] > 0) {
        keys[count++] = (long) fingerprint(coupled[k]) << 32 | k;
      }
    }
    Arrays.sort(keys, 0, count);
    for (int a = 0; a < count; a++) {
      int i = coupled[(int) keys[a]];
      if (weight[i] == 0) {
        continue;
      }
      for (int b = a + 1; b < count && keys[b] >> 32 == keys[a] >> 32; b++) {
        int j = coupled[(int) keys[b]];
        if (weight[j] > 0 && alike(i, j)) {
          merge(i, j);
        }
      }
    }
  }

  private int fingerprint(int i) {
    int sum = neighbourCount[i] + 31 * elementCount[i];
    for (int k = 0; k < neighbourCount[i]; k++) {
      sum += neighbours[i][k] * 7;
    }
    for (int k = 0; k < elementCount[i]; k++) {
      sum += elements[i][k] * 13;
    }
    return sum & Integer.MAX_VALUE;
  }

  private boolean alike(int i, int j) {
    if (neighbourCount[i] != neighbourCount[j] || elementCount[i] != elementCount[j]) {
      return false;
    }
    marked++;
    for (int k = 0; k < neighbourCount[i]; k++) {
      mark[neighbours[i][k]] = marked;
    }
    for (int k = 0; k < neighbourCount[j]; k++) {
      if (mark[neighbours[j][k]] != marked) {
        return false;
      }
    }
    marked++;
    for (int k = 0; k < elementCount[i]; k++) {
      mark[elements[i][k]] = marked;
    }
    for (int k = 0; k < elementCount[j]; k++) {
      if (mark[elements[j][k]] != marked) {
        return false;
      }
    }
    return true;
  }

  private void merge(int i, int j) {
    degree[i] -= weight[j];
    weight[i] += weight[j];
    weight[j] = 0;
    follower[lastFollower[i]] = j;
    lastFollower[i] = lastFollower[j];
    neighbours[j] = EMPTY;
    elements[j] = EMPTY;
  }
}
