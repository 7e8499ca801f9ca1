package org.mechservice.solver.linear;

import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.stream.Stream;

/**
 * An order in which a sparse symmetric matrix is eliminated, and what each row is coupled with when
 * its turn comes: always the row that is coupled with the fewest (Tinney and Walker 1967). For
 * setting up.
 */
final class LeastDegree {
  private final int[] memberAt;
  private final int[][] after;
  private final List<Set<Integer>> coupled;
  private final boolean[] done;
  private int next;

  /** A row and how many it was coupled with when it was put in the queue. */
  private record Candidate(int row, int degree) implements Comparable<Candidate> {
    @Override
    public int compareTo(Candidate other) {
      int byDegree = Integer.compare(degree, other.degree);
      return byDegree != 0 ? byDegree : Integer.compare(row, other.row);
    }
  }

  LeastDegree(int size, List<int[]> cliques, int[] first) {
    memberAt = new int[size];
    after = new int[size][];
    done = new boolean[size];
    coupled = Stream.<Set<Integer>>generate(HashSet::new).limit(size).toList();
    Set<List<Integer>> seen = new HashSet<>();
    for (int[] clique : cliques) {
      if (seen.add(Arrays.stream(clique).boxed().toList())) {
        couple(clique);
      }
    }
    for (int row : first) {
      eliminate(row);
    }
    PriorityQueue<Candidate> queue = new PriorityQueue<>();
    for (int row = 0; row < size; row++) {
      if (!done[row]) {
        queue.add(new Candidate(row, coupled.get(row).size()));
      }
    }
    while (!queue.isEmpty()) {
      Interruption.check();
      Candidate candidate = queue.remove();
      int row = candidate.row;
      if (!done[row] && candidate.degree == coupled.get(row).size()) {
        int[] neighbours = eliminate(row);
        for (int other : neighbours) {
          queue.add(new Candidate(other, coupled.get(other).size()));
        }
      }
    }
  }

  private void couple(int[] clique) {
    for (int i : clique) {
      for (int j : clique) {
        if (i != j) {
          coupled.get(i).add(j);
        }
      }
    }
  }

  private int[] eliminate(int row) {
    int[] neighbours = coupled.get(row).stream().mapToInt(Integer::intValue).toArray();
    for (int other : neighbours) {
      coupled.get(other).remove(row);
    }
    couple(neighbours);
    memberAt[next] = row;
    after[next++] = neighbours;
    done[row] = true;
    return neighbours;
  }

  /** Returns the rows in the order of elimination. */
  int[] memberAt() {
    return memberAt;
  }

  /** Returns the rows that the k-th is coupled with when it is eliminated, in no order. */
  int[] coupledAfter(int k) {
    return after[k];
  }
}
