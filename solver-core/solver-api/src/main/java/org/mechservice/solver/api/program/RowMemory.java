package org.mechservice.solver.api.program;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;
import java.util.List;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** Rows in memory outside the heap, one after the other, where other languages read them too. */
public final class RowMemory implements ResultSink {
  private static final int FIRST_ROWS = 256;
  private static final int MOST_DOUBLES = Integer.MAX_VALUE / Double.BYTES;

  private List<Variable> columns = List.of();
  private DoubleBuffer values = direct(0);
  private int rows;

  private static DoubleBuffer direct(int count) {
    return ByteBuffer.allocateDirect(count * Double.BYTES)
        .order(ByteOrder.nativeOrder())
        .asDoubleBuffer();
  }

  @Override
  public void begin(List<Variable> announced) {
    columns = List.copyOf(announced);
    values = direct(FIRST_ROWS * columns.size());
  }

  @Override
  public void row(double[] row) {
    if (values.remaining() < row.length) {
      grow(row.length);
    }
    values.put(row);
    rows++;
  }

  private void grow(int needed) {
    long wanted = Math.min(MOST_DOUBLES, Math.max(2L * values.capacity(), needed));
    if (wanted < values.position() + (long) needed) {
      throw new IllegalStateException(
          "the rows take more than 2 GB of memory after row "
              + rows
              + "; write them to a file, or ask for fewer columns or rows");
    }
    DoubleBuffer larger = direct((int) wanted);
    values.flip();
    larger.put(values);
    values = larger;
  }

  /** Returns the columns in order, the first is time. */
  public List<Variable> columns() {
    return columns;
  }

  /** Returns how many rows there are. */
  public int rows() {
    return rows;
  }

  double get(int row, int column) {
    return values.get(row * columns.size() + column);
  }

  /** Returns a view of the values so far, row by row. */
  DoubleBuffer values() {
    DoubleBuffer view = values.duplicate();
    view.flip();
    return view.slice();
  }
}
