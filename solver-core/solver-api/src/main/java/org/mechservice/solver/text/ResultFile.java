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
 * A CSV file of results with its units beside it ({@code r.csv}, {@code r.units.json}). It grows
 * under another name in the same folder and takes its place only when it is {@linkplain #keep
 * kept}, so that no half-written file is ever found under the name asked for.
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
   * @param target name the results will have
   * @throws IOException if the folder does not exist or cannot be written to, or the name is that
   *     of a folder or a device, whose place no file may take
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
    // Not a temporary file of the JDK's making: those are readable for their owner only.
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

  /** What was computed is not lost with a full disk: it stays under the temporary name. */
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
   * Puts the file in its place, replacing one of that name, and writes the units beside it.
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
   * Returns where the units are written: beside the results, {@code .csv} replaced by {@code
   * .units.json}.
   */
  public Path unitsFile() {
    String name = String.valueOf(target.getFileName());
    String stem =
        name.endsWith(EXTENSION) ? name.substring(0, name.length() - EXTENSION.length()) : name;
    return target.resolveSibling(stem + ".units.json");
  }

  /** Closes the file; what was not {@linkplain #keep kept} is deleted, unless writing failed. */
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
