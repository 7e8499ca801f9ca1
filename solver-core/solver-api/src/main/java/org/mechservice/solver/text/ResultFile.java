package org.mechservice.solver.text;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.List;
import java.util.UUID;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A file of results, by default CSV with its units beside it ({@code r.csv}, {@code r.units.json}).
 * Rows are written to a temporary file in the same folder, which {@link #keep} renames to the
 * requested name. A file of that name is therefore always complete.
 */
public final class ResultFile implements ResultSink, Closeable {
  /** A file format of results. */
  public interface Format {
    /** Returns the ending of the names of its files, with the dot. */
    String ending();

    /** Returns whether the units are written in a file of their own, since it has no place. */
    boolean unitsBeside();

    /** Returns whether the rows of a file that was not finished can be read. */
    boolean readableUnfinished();

    /**
     * Opens a writer.
     *
     * @param out receives the bytes in order; the writer closes it
     * @param file where they go; the writer may put scratch files beside it, which it deletes
     * @throws IOException if it needs a scratch file and cannot make it
     */
    ResultWriter writer(OutputStream out, Path file) throws IOException;
  }

  private static final Format CSV =
      new Format() {
        @Override
        public String ending() {
          return ".csv";
        }

        @Override
        public boolean unitsBeside() {
          return true;
        }

        @Override
        public boolean readableUnfinished() {
          return true;
        }

        @Override
        public ResultWriter writer(OutputStream out, Path file) {
          return new CsvWriter(out);
        }
      };

  private final Format format;
  private final Path target;
  private final Path growing;
  private final MessageDigest digest;
  private final ResultWriter writer;
  private List<Variable> columns = List.of();
  private boolean kept;

  /**
   * Opens a CSV file under its temporary name.
   *
   * @param target final name of the results
   * @throws IOException as {@link #ResultFile(Path, Format)}
   */
  public ResultFile(Path target) throws IOException {
    this(target, CSV);
  }

  /**
   * Opens the file under its temporary name.
   *
   * @param target final name of the results
   * @param format how they are written
   * @throws IOException if the folder does not exist or cannot be written to, or the name is that
   *     of a folder or a device
   */
  public ResultFile(Path target, Format format) throws IOException {
    this.format = format;
    this.target = target.toAbsolutePath();
    Path folder = this.target.getParent();
    if (folder == null || (Files.exists(this.target) && !Files.isRegularFile(this.target))) {
      throw new IOException(
          MessageCode.RESULTS_NOT_WRITTEN + " " + target + " is no file; name one for the results");
    }
    if (!Files.isDirectory(folder)) {
      throw new IOException(
          MessageCode.RESULTS_NOT_WRITTEN + " there is no folder " + folder + " for the results");
    }
    // Files.createTempFile is not used: it makes files that only their owner can read.
    growing = folder.resolve("." + this.target.getFileName() + "-" + UUID.randomUUID() + ".part");
    digest = Sha256.digest();
    OutputStream out = new DigestOutputStream(new BufferedOutputStream(open(growing)), digest);
    writer = opened(out);
  }

  private ResultWriter opened(OutputStream out) throws IOException {
    try {
      return format.writer(out, growing);
    } catch (IOException e) {
      try (out) {
        Files.deleteIfExists(growing);
      }
      throw e;
    }
  }

  private static OutputStream open(Path file) throws IOException {
    try {
      return Files.newOutputStream(file);
    } catch (IOException e) {
      throw new IOException(
          MessageCode.RESULTS_NOT_WRITTEN
              + " cannot write in folder "
              + file.getParent()
              + ": "
              + reason(e),
          e);
    }
  }

  /** Returns why a file cannot be opened; the file's name is that of the growing one. */
  private static String reason(IOException failure) {
    if (failure instanceof AccessDeniedException) {
      return "permission denied";
    }
    return failure instanceof FileSystemException file && file.getReason() != null
        ? file.getReason()
        : failure.toString();
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    this.columns = List.copyOf(columns);
    writer.begin(columns);
  }

  @Override
  public void row(double[] values) throws IOException {
    try {
      writer.row(values);
    } catch (IOException e) {
      throw stopped(e);
    }
  }

  /**
   * Returns the error with the name of the temporary file, which is kept if it can be read, for
   * example when the disk is full.
   */
  private IOException stopped(IOException e) {
    kept = format.readableUnfinished() || finished();
    return new IOException(
        MessageCode.RESULTS_NOT_WRITTEN
            + " cannot write "
            + target
            + ": "
            + e.getMessage()
            + (kept
                ? "; rows so far are in " + growing
                : "; rows so far are lost: a "
                    + format.ending()
                    + " file is complete only at the end, a .csv file keeps them"),
        e);
  }

  private boolean finished() {
    try {
      writer.finish();
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /**
   * Renames the file to its final name, replacing an existing file, and writes the units file.
   *
   * @return the SHA-256 of the file, lower-case hexadecimal
   * @throws IOException if the file cannot be completed; its message says where the rows are
   */
  public String keep() throws IOException {
    try {
      writer.finish();
      writer.close();
      if (format.unitsBeside()) {
        Path units = growing.resolveSibling(growing.getFileName() + ".units");
        Files.write(units, (CsvWriter.unitsJson(columns) + "\n").getBytes(StandardCharsets.UTF_8));
        Files.move(units, unitsFile(), StandardCopyOption.REPLACE_EXISTING);
      }
      Files.move(growing, target, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw stopped(e);
    }
    kept = true;
    return HexFormat.of().formatHex(digest.digest());
  }

  /**
   * Returns the name of the units file, for formats that have no place for units: that of the
   * results with {@code .csv} replaced by {@code .units.json}.
   */
  public Path unitsFile() {
    String name = String.valueOf(target.getFileName());
    String stem =
        name.endsWith(format.ending())
            ? name.substring(0, name.length() - format.ending().length())
            : name;
    return target.resolveSibling(stem + ".units.json");
  }

  /**
   * Closes the file and deletes it if it was not {@linkplain #keep kept}, unless writing failed.
   */
  @Override
  public void close() throws IOException {
    try {
      writer.close();
    } finally {
      if (!kept) {
        Files.deleteIfExists(growing);
      }
    }
  }
}
