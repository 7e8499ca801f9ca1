package org.mechservice.sim.user;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.guard.LostProcessException;
import org.mechservice.guard.WarmProcesses;
import org.mechservice.guard.WorkerBounds;
import org.mechservice.solver.text.WellFormedText;

/**
 * The Java compiler in a process of its own, with bounded memory and time: two kilobytes of source
 * can make it take gigabytes. A process serves one request at a time and then waits for the next,
 * for a minute, so that later sources find a compiler that is warm. A thread that is interrupted
 * while it waits ends its process.
 */
final class CompilerProcess {
  /** Enough for ten thousand lines; a source of users has a few hundred. */
  private static final WorkerBounds BOUNDS = new WorkerBounds(512L << 20, -1);

  private static final long PATIENCE_SECONDS = 60;
  private static final int MOST_IDLE = 2;
  private static final int MOST_FILES = 10_000;
  private static final int MOST_BYTES = 64 << 20;

  /** Each waits for a caller that has a thread; the caller bounds how many there are. */
  private static final WarmProcesses WARM =
      new WarmProcesses(CompilerMain.class, false, Integer.MAX_VALUE, MOST_IDLE);

  /**
   * A message of the compiler.
   *
   * @param file name of the source; empty: of none
   * @param position of the place in the text, negative if unknown
   * @param end of the place in the text
   * @param code of the compiler
   */
  record Said(String file, int line, int column, int position, int end, String code, String text) {}

  /**
   * What has come of some sources.
   *
   * @param classFiles by binary name; none if there is an error
   * @param errors messages, of which the first is usually the cause of the others
   * @param givenUp why there is no result; empty if there is one
   */
  record Result(SortedMap<String, byte[]> classFiles, List<Said> errors, String givenUp) {}

  private final DataOutputStream out;
  private final DataInputStream in;

  private CompilerProcess(DataOutputStream out, DataInputStream in) {
    this.out = out;
    this.in = in;
  }

  /**
   * Compiles sources.
   *
   * @param sources texts by file name
   * @param others class files that they may name, by binary name; not modified
   */
  static Result compile(Map<String, String> sources, SortedMap<String, byte[]> others) {
    try {
      return WARM.ask(
          BOUNDS,
          "",
          PATIENCE_SECONDS,
          (out, in) -> new CompilerProcess(out, in).ask(sources, others));
    } catch (LostProcessException e) {
      return failed(String.valueOf(e.getMessage()));
    } catch (IOException e) {
      return failed("its process could not be used: " + e.getMessage());
    }
  }

  /** Starts a process ahead of the first source, so that it need not wait for Java to start. */
  static void prepare() {
    Thread starting =
        new Thread(
            () -> {
              try {
                WARM.prepare(BOUNDS, (out, in) -> "");
              } catch (IOException e) {
                // The first source finds out.
              }
            },
            "mechservice-compiler-start");
    starting.setDaemon(true);
    starting.start();
  }

  private static Result failed(String why) {
    return new Result(new TreeMap<>(), List.of(), why);
  }

  private Result ask(Map<String, String> sources, SortedMap<String, byte[]> others)
      throws IOException {
    out.writeByte(0);
    out.writeInt(sources.size());
    for (Map.Entry<String, String> source : sources.entrySet()) {
      out.writeUTF(source.getKey());
      write(source.getValue().getBytes(StandardCharsets.UTF_8));
    }
    out.writeInt(others.size());
    for (Map.Entry<String, byte[]> other : others.entrySet()) {
      out.writeUTF(other.getKey());
      write(other.getValue());
    }
    out.flush();
    String givenUp = text();
    SortedMap<String, byte[]> classFiles = new TreeMap<>();
    int files = count(in.readInt());
    for (int i = 0; i < files; i++) {
      String name = text();
      classFiles.put(name, in.readNBytes(bounded(in.readInt())));
    }
    List<Said> errors = new ArrayList<>();
    int messages = count(in.readInt());
    for (int i = 0; i < messages; i++) {
      errors.add(
          new Said(text(), in.readInt(), in.readInt(), in.readInt(), in.readInt(), text(), text()));
    }
    return new Result(classFiles, errors, givenUp);
  }

  private void write(byte[] bytes) throws IOException {
    out.writeInt(bytes.length);
    out.write(bytes);
  }

  private String text() throws IOException {
    return WellFormedText.of(in.readUTF());
  }

  private static int count(int files) throws IOException {
    if (files < 0 || files > MOST_FILES) {
      throw new IOException("it answers with " + files + " files");
    }
    return files;
  }

  private static int bounded(int bytes) throws IOException {
    if (bytes < 0 || bytes > MOST_BYTES) {
      throw new IOException("it answers with a file of " + bytes + " bytes");
    }
    return bytes;
  }
}
