package org.mechservice.view.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * The rows of a file that a diagram needs, in bounded memory. Consecutive rows form buckets, which
 * are joined in pairs whenever there are too many. A bucket keeps its first and last row, for each
 * column the rows with its least and its greatest value, and one row with a gap if there is one: no
 * peak is lost, however long the file. A file with fewer rows than buckets is kept whole.
 */
final class ThinnedRows implements Consumer<double[]> {
  /** A row and its place in the file. */
  private static final class Row {
    private final long at;
    private final double[] values;

    Row(long at, double[] values) {
      this.at = at;
      this.values = values;
    }
  }

  /** Rows that follow each other. */
  private static final class Bucket {
    private final Row first;
    private Row last;
    private long count = 1;
    private final Row[] least;
    private final Row[] greatest;
    private final Row[] gap;

    Bucket(Row row) {
      first = row;
      last = row;
      int columns = row.values.length;
      least = new Row[columns];
      greatest = new Row[columns];
      gap = new Row[columns];
      for (int c = 0; c < columns; c++) {
        least[c] = row;
        greatest[c] = row;
        gap[c] = row;
      }
    }

    void join(Bucket next) {
      last = next.last;
      count += next.count;
      for (int c = 0; c < least.length; c++) {
        // Comparisons with NaN are false: a number takes the place of a gap.
        if (!(least[c].values[c] <= next.least[c].values[c])
            && !Double.isNaN(next.least[c].values[c])) {
          least[c] = next.least[c];
        }
        if (!(greatest[c].values[c] >= next.greatest[c].values[c])
            && !Double.isNaN(next.greatest[c].values[c])) {
          greatest[c] = next.greatest[c];
        }
        if (!Double.isNaN(gap[c].values[c])) {
          gap[c] = next.gap[c];
        }
      }
    }

    void collect(SortedMap<Long, double[]> rows) {
      put(rows, first);
      put(rows, last);
      for (int c = 0; c < least.length; c++) {
        put(rows, least[c]);
        put(rows, greatest[c]);
        if (Double.isNaN(gap[c].values[c])) {
          put(rows, gap[c]);
        }
      }
    }

    private static void put(SortedMap<Long, double[]> rows, Row row) {
      rows.put(row.at, row.values);
    }
  }

  private final int most;
  private List<Bucket> buckets = new ArrayList<>();
  private long inBucket = 1;
  private long count;

  /**
   * Starts without rows.
   *
   * @param most number of buckets above which they are joined, even
   */
  ThinnedRows(int most) {
    this.most = most;
  }

  @Override
  public void accept(double[] values) {
    Bucket bucket = new Bucket(new Row(count, values));
    count++;
    Bucket latest = buckets.isEmpty() ? bucket : buckets.get(buckets.size() - 1);
    if (latest != bucket && latest.count < inBucket) {
      latest.join(bucket);
      return;
    }
    buckets.add(bucket);
    if (buckets.size() > most) {
      List<Bucket> joined = new ArrayList<>();
      for (int i = 0; i < buckets.size(); i += 2) {
        Bucket one = buckets.get(i);
        if (i + 1 < buckets.size()) {
          one.join(buckets.get(i + 1));
        }
        joined.add(one);
      }
      buckets = joined;
      inBucket *= 2;
    }
  }

  /** Returns how many rows were there. */
  long count() {
    return count;
  }

  /** Returns the rows that are kept, in their order. */
  List<double[]> rows() {
    SortedMap<Long, double[]> rows = new TreeMap<>();
    buckets.forEach(bucket -> bucket.collect(rows));
    return List.copyOf(rows.values());
  }
}
