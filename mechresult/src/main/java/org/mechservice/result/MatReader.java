package org.mechservice.result;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.result.Variable;
import us.hebi.matlab.mat.format.Mat5;
import us.hebi.matlab.mat.format.Mat5File;
import us.hebi.matlab.mat.types.Cell;
import us.hebi.matlab.mat.types.Matrix;

/** Reads the variables {@code data}, {@code names} and {@code units} of a MAT file. */
final class MatReader {
  private MatReader() {}

  static SignalTable read(Path file) throws IOException {
    MatStructure.require(file);
    Mat5File mat = Mat5.readFromFile(file.toFile());
    Cell names = mat.getCell("names");
    Cell units = mat.getCell("units");
    Matrix data = mat.getMatrix("data");
    if (data.getNumCols() != names.getNumElements()) {
      throw new IOException(
          "data has "
              + data.getNumCols()
              + " columns and names has "
              + names.getNumElements()
              + " texts");
    }
    List<Variable> columns = new ArrayList<>();
    List<double[]> values = new ArrayList<>();
    for (int column = 0; column < data.getNumCols(); column++) {
      String unit = units.getChar(column).getString();
      columns.add(new Variable(names.getChar(column).getString(), unit));
      double[] rows = new double[data.getNumRows()];
      for (int row = 0; row < rows.length; row++) {
        rows[row] = data.getDouble(row, column);
      }
      values.add(rows);
    }
    return new SignalTable(columns, values);
  }
}
