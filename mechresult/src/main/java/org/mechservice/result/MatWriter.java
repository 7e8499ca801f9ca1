package org.mechservice.result;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.zip.Deflater;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.ResultWriter;
import us.hebi.matlab.mat.format.Mat5;
import us.hebi.matlab.mat.format.Mat5File;
import us.hebi.matlab.mat.format.Mat5Serializable;
import us.hebi.matlab.mat.format.Mat5Type;
import us.hebi.matlab.mat.format.Mat5WriteUtil;
import us.hebi.matlab.mat.types.AbstractArray;
import us.hebi.matlab.mat.types.Cell;
import us.hebi.matlab.mat.types.MatlabType;
import us.hebi.matlab.mat.types.Sink;
import us.hebi.matlab.mat.types.Sinks;

/**
 * Writes rows as a MAT file of level 5 with three variables: {@code names} and {@code units}, cells
 * of one text for each column, and {@code data}, a matrix of one row for each row and one column
 * for each column.
 *
 * <p>The format stores a matrix column after column. So the rows first go to a scratch file, in
 * blocks of fixed size that are stored column after column each; {@link #finish} joins the parts of
 * every column. A result is thus written twice and never held in memory.
 */
final class MatWriter implements ResultWriter {
  /** A variable's length is a 32-bit number with a sign in the programs that read the format. */
  private static final long LARGEST_VARIABLE = Integer.MAX_VALUE;

  /** Tags, flags, sizes and name before the numbers of {@code data}, generously. */
  private static final int HEADER_ALLOWANCE = 256;

  private static final int BLOCK_BYTES = 1 << 23;

  private final OutputStream out;
  private final FileChannel scratch;
  private List<Variable> columns = List.of();
  private double[] block = new double[0];
  private int blockRows;
  private int rowsInBlock;
  private long rows;

  /**
   * @param file the scratch file is beside it
   */
  MatWriter(OutputStream out, Path file) throws IOException {
    this.out = out;
    scratch =
        FileChannel.open(
            file.resolveSibling(file.getFileName() + ".rows"),
            StandardOpenOption.CREATE_NEW,
            StandardOpenOption.READ,
            StandardOpenOption.WRITE,
            StandardOpenOption.DELETE_ON_CLOSE);
  }

  /** Returns why a matrix cannot be stored; empty if it can. */
  static Optional<String> refusal(long rows, int columns) {
    long most = (LARGEST_VARIABLE - HEADER_ALLOWANCE) / Double.BYTES / Math.max(1, columns);
    return rows <= most
        ? Optional.empty()
        : Optional.of(
            "a MAT file holds 2 GB in a variable, that is "
                + most
                + " rows of "
                + columns
                + " columns; write .parquet or .csv, or fewer columns or rows");
  }

  @Override
  public void begin(List<Variable> columns) {
    this.columns = List.copyOf(columns);
    blockRows = Math.max(1, BLOCK_BYTES / Double.BYTES / columns.size());
    block = new double[Math.min(blockRows, 64) * columns.size()];
  }

  @Override
  public void row(double[] values) throws IOException {
    Optional<String> refused = refusal(rows + 1, columns.size());
    if (refused.isPresent()) {
      throw new IOException(MessageCode.RESULT_TOO_LARGE + " " + refused.get());
    }
    int at = rowsInBlock * columns.size();
    if (at == block.length) {
      int most = blockRows * columns.size();
      block = Arrays.copyOf(block, (int) Math.min(most, 2L * block.length));
    }
    System.arraycopy(values, 0, block, at, columns.size());
    rows++;
    rowsInBlock++;
    if (rowsInBlock == blockRows) {
      spill();
    }
  }

  /** Appends the block to the scratch file, column after column. */
  private void spill() throws IOException {
    ByteBuffer bytes = littleEndian(rowsInBlock * columns.size());
    for (int column = 0; column < columns.size(); column++) {
      for (int row = 0; row < rowsInBlock; row++) {
        bytes.putDouble(block[row * columns.size() + column]);
      }
    }
    bytes.flip();
    while (bytes.hasRemaining()) {
      scratch.write(bytes);
    }
    rowsInBlock = 0;
  }

  private static ByteBuffer littleEndian(int numbers) {
    return ByteBuffer.allocate(numbers * Double.BYTES).order(ByteOrder.LITTLE_ENDIAN);
  }

  @Override
  public void finish() throws IOException {
    if (rowsInBlock > 0) {
      spill();
    }
    Sink sink = Sinks.wrapNonSeeking(out).order(ByteOrder.LITTLE_ENDIAN);
    Mat5File file = new Headed();
    file.addArray("names", texts(Variable::name));
    file.addArray("units", texts(Variable::unit));
    file.addArray("data", new Data((int) rows, columns.size()));
    Mat5.newWriter(sink).setDeflateLevel(Deflater.NO_COMPRESSION).writeMat(file).flush();
    out.flush();
  }

  private Cell texts(Function<Variable, String> text) {
    Cell cell = Mat5.newCell(columns.size(), 1);
    for (int i = 0; i < columns.size(); i++) {
      cell.set(i, Mat5.newString(text.apply(columns.get(i))));
    }
    return cell;
  }

  @Override
  public void close() throws IOException {
    try (out;
        scratch) {
      block = new double[0];
    }
  }

  /** A file whose header does not depend on the day it was written. */
  private static final class Headed extends Mat5File {
    Headed() {
      super("MATLAB 5.0 MAT-file, MechService results");
    }
  }

  /** The matrix of all rows, read from the scratch file while it is written. */
  private final class Data extends AbstractArray implements Mat5Serializable {
    Data(int rows, int columns) {
      super(Mat5.dims(rows, columns));
    }

    @Override
    public MatlabType getType() {
      return MatlabType.Double;
    }

    @Override
    public int getMat5Size(String name) {
      return Mat5.MATRIX_TAG_SIZE
          + Mat5WriteUtil.computeArrayHeaderSize(name, this)
          + Mat5Type.Double.computeSerializedSize(getNumElements());
    }

    @Override
    public void writeMat5(String name, boolean isGlobal, Sink sink) throws IOException {
      Mat5WriteUtil.writeMatrixTag(name, this, sink);
      Mat5WriteUtil.writeArrayHeader(name, isGlobal, this, sink);
      Mat5Type.Double.writeTag(getNumElements(), sink);
      for (int column = 0; column < getNumCols(); column++) {
        for (long first = 0; first < rows; first += blockRows) {
          int count = (int) Math.min(blockRows, rows - first);
          ByteBuffer part = littleEndian(count);
          long at = (first * getNumCols() + (long) column * count) * Double.BYTES;
          while (part.hasRemaining()) {
            scratch.read(part, at + part.position());
          }
          sink.writeBytes(part.array(), part.arrayOffset(), part.capacity());
        }
      }
      Mat5Type.Double.writePadding(getNumElements(), sink);
    }

    @Override
    protected int subHashCode() {
      return System.identityHashCode(this);
    }

    @Override
    protected boolean subEqualsGuaranteedSameClass(Object other) {
      return this == other;
    }

    @Override
    public void close() {}
  }
}
