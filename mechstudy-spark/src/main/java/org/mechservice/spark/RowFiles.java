package org.mechservice.spark;

import java.io.BufferedReader;
import java.io.FileNotFoundException;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.UUID;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.apache.hadoop.conf.Configuration;
import org.apache.hadoop.fs.FileStatus;
import org.apache.hadoop.fs.FileSystem;
import org.apache.hadoop.fs.Path;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.text.Sha256;

/**
 * The files of rows that executors write, in a folder of any file system that Hadoop knows. A file
 * is named after its points, {@code FIRST-END.rows}, and has its name only when it is whole. Its
 * first line says which study it belongs to.
 */
final class RowFiles implements AutoCloseable {
  private static final Pattern NAME = Pattern.compile("(\\d{1,10})-(\\d{1,10})\\.rows");

  private final FileSystem system;
  private final Path folder;
  private final String study;

  /** Takes rows. */
  interface RowReader {
    /**
     * Takes a row without its line break.
     *
     * @return whether more are wanted
     */
    boolean take(String line) throws IOException;
  }

  /**
   * @param folder with the scheme of its file system
   * @param identity what the rows depend on
   */
  RowFiles(String folder, Configuration hadoop, String identity) throws IOException {
    this.folder = new Path(folder);
    study = Sha256.of(identity.getBytes(StandardCharsets.UTF_8));
    // One of its own: Spark's are shared and have other settings.
    system = FileSystem.newInstance(this.folder.toUri(), hadoop);
    system.setWriteChecksum(false);
    system.setVerifyChecksum(false);
  }

  private Path file(Chunk chunk) {
    return new Path(folder, chunk.first() + "-" + chunk.end() + ".rows");
  }

  /**
   * Writes the rows of a chunk; another executor may have written the same ones.
   *
   * @param lines with their line breaks
   */
  void write(Chunk chunk, String lines) throws IOException {
    Path growing = new Path(folder, "." + file(chunk).getName() + "." + UUID.randomUUID());
    try (OutputStream out = system.create(growing, true)) {
      out.write((study + "\n" + lines).getBytes(StandardCharsets.UTF_8));
    }
    publish(growing, file(chunk));
  }

  /** Gives a whole file its name. */
  private void publish(Path growing, Path file) throws IOException {
    if (!system.rename(growing, file)) {
      system.delete(growing, false);
      if (!system.exists(file)) {
        throw new IOException(MessageCode.FILE_UNUSABLE + " " + file + " cannot be written");
      }
    }
  }

  /**
   * Returns the chunks whose rows are there, by their first points.
   *
   * @throws IOException S-181 if a file belongs to another study
   */
  List<Chunk> found() throws IOException {
    List<Chunk> found = new ArrayList<>();
    FileStatus[] files;
    try {
      files = system.listStatus(folder);
    } catch (FileNotFoundException e) {
      return found;
    }
    for (FileStatus file : files) {
      Matcher name = NAME.matcher(file.getPath().getName());
      if (name.matches()) {
        Chunk chunk = new Chunk(Integer.parseInt(name.group(1)), Integer.parseInt(name.group(2)));
        read(chunk, line -> false);
        found.add(chunk);
      }
    }
    found.sort(Comparator.comparingInt(Chunk::first).thenComparingInt(Chunk::end));
    return found;
  }

  /** Hands out the rows of a chunk until no more are wanted. */
  void read(Chunk chunk, RowReader rows) throws IOException {
    Path file = file(chunk);
    try (BufferedReader lines =
        new BufferedReader(new InputStreamReader(system.open(file), StandardCharsets.UTF_8))) {
      if (!study.equals(lines.readLine())) {
        throw new IOException(
            MessageCode.STUDY_CHANGED
                + " "
                + folder
                + " has rows of another study file, model or version; delete it to begin anew, or"
                + " write elsewhere with -o");
      }
      boolean wanted = true;
      for (String line = lines.readLine(); wanted && line != null; line = lines.readLine()) {
        wanted = rows.take(line);
      }
    } catch (FileNotFoundException e) {
      throw new IOException(
          MessageCode.FILE_UNUSABLE
              + " "
              + file
              + " was written by an executor and is not seen by the driver: -o must be in a file"
              + " system that all of them share, such as hdfs: or s3a:",
          e);
    }
  }

  /** Writes a text file; it has its name only when it is whole. */
  void write(Path file, Content content) throws IOException {
    Path growing = new Path(file.getParent(), "." + file.getName() + ".growing");
    try (OutputStream out = system.create(growing, true)) {
      content.to(out);
    }
    system.delete(file, false);
    publish(growing, file);
  }

  /** Writes a file's bytes. */
  interface Content {
    void to(OutputStream out) throws IOException;
  }

  /** Deletes the files of rows. */
  void delete() throws IOException {
    system.delete(folder, true);
  }

  @Override
  public void close() throws IOException {
    system.close();
  }
}
