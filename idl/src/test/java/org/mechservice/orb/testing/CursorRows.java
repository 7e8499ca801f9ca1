package org.mechservice.orb.testing;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.idl.ResultBlock;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.ServerFailure;

/** Reads rows from a cursor. */
public final class CursorRows {
  private CursorRows() {}

  /**
   * Returns all rows from the place of the cursor to the end of data.
   *
   * @param maxRows most rows per block; 0: as many as fit
   */
  public static List<double[]> toEnd(ResultCursor cursor, int maxRows)
      throws LimitExceeded, ServerFailure {
    List<double[]> rows = new ArrayList<>();
    ResultBlockHolder holder = new ResultBlockHolder();
    do {
      cursor.nextBlock(maxRows, 1000, holder);
      ResultBlock block = holder.value;
      for (int row = 0; row < block.rowCount; row++) {
        double[] values = new double[block.columnCount];
        System.arraycopy(block.values, row * block.columnCount, values, 0, values.length);
        rows.add(values);
      }
    } while (!holder.value.endOfData);
    return rows;
  }
}
