package org.mechservice.solver.text;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.UUID;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * A CSV file of results with its units beside it ({@code r.csv}, {@code r.units.json}). Rows are
 * written to a temporary file in the same folder, which {@link #keep} renames to the requested
 * name. A file of that name is therefore always complete.
 */
public final class ResultFile implements ResultSink, Closeable {
  private static final String EXTENSION = ".csv";

  private final Path target;
  private final Path growing;
  private final MessageDigest digest;
  private final CsvWriter csv;
  private List<Variable> columns = List.of();
  private boolean kept;

  /**
   * Opens the file under its temporary name.
   *
   * @param target final name of the results
   * @throws IOException if the folder does not exist or cannot be written to, or the name is that
   *     of a folder or a device
   */
  public ResultFile(Path target) throws IOException {
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
    digest = sha256Digest();
    csv = new CsvWriter(new DigestOutputStream(new BufferedOutputStream(open(growing)), digest));
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
              + e,
          e);
    }
  }

  private static MessageDigest sha256Digest() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java platform has SHA-256", e);
    }
  }

  @Override
  public void begin(List<Variable> columns) throws IOException {
    this.columns = List.copyOf(columns);
    csv.begin(columns);
  }

  @Override
  public void row(double[] values) throws IOException {
    try {
      csv.row(values);
    } catch (IOException e) {
      throw stopped(e);
    }
  }

  /**
   * Returns the error with the name of the temporary file, which is kept, for example when the disk
   * is full.
   */
  private IOException stopped(IOException e) {
    kept = true;
    return new IOException(
        MessageCode.RESULTS_NOT_WRITTEN
            + " cannot write "
            + target
            + ": "
            + e.getMessage()
            + "; rows so far are in "
            + growing,
        e);
  }

  /**
   * Renames the file to its final name, replacing an existing file, and writes the units file.
   *
   * @return the SHA-256 of the CSV file, lower-case hexadecimal
   * @throws IOException if the file cannot be completed; its message says where the rows are
   */
  public String keep() throws IOException {
    try {
      csv.close();
      Path units = growing.resolveSibling(growing.getFileName() + ".units");
      Files.write(units, (CsvWriter.unitsJson(columns) + "\n").getBytes(StandardCharsets.UTF_8));
      Files.move(units, unitsFile(), StandardCopyOption.REPLACE_EXISTING);
      Files.move(growing, target, StandardCopyOption.REPLACE_EXISTING);
    } catch (IOException e) {
      throw stopped(e);
    }
    kept = true;
    return HexFormat.of().formatHex(digest.digest());
  }

  /**
   * Returns the path of the units file: that of the results with {@code .csv} replaced by {@code
   * .units.json}.
   */
  public Path unitsFile() {
    String name = String.valueOf(target.getFileName());
    String stem =
        name.endsWith(EXTENSION) ? name.substring(0, name.length() - EXTENSION.length()) : name;
    return target.resolveSibling(stem + ".units.json");
  }

  /**
   * Closes the file and deletes it if it was not {@linkplain #keep kept}, unless writing failed.
   */
  @Override
  public void close() throws IOException {
    try {
      csv.close();
    } finally {
      if (!kept) {
        Files.deleteIfExists(growing);
      }
    }
  }
}
