package org.mechservice.sim.jar;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.standalone.Launcher;
import org.objectweb.asm.ClassReader;

/**
 * Classes in one file, which compresses far better than many small ones: what they name is told
 * once for all, and like stands beside like: the tags of all constants, which strings they are, the
 * other constants, and last what is not constants. Read by the {@link Launcher} of a standalone
 * JAR.
 */
public final class SolidClasses {
  /** By package, in it by size: neighbours share names, and small classes are alike. */
  private static final Comparator<Map.Entry<String, byte[]>> ORDER =
      Comparator.comparing((Map.Entry<String, byte[]> file) -> packageOf(file.getKey()))
          .thenComparing(file -> file.getValue().length)
          .thenComparing(Map.Entry::getKey);

  /** A class file, and where its constants are. */
  @SuppressWarnings("ArrayRecordComponent") // never changed
  private record Content(byte[] bytes, ClassReader reader) {
    Content(byte[] bytes) {
      this(bytes, new ClassReader(bytes));
    }

    int constants() {
      return reader.getItemCount();
    }

    /** Returns the tag of a constant; 0 for the unused second half of a long or double. */
    int tag(int item) {
      int at = reader.getItem(item);
      return at == 0 ? 0 : bytes[at - 1];
    }

    String string(int item) throws IOException {
      int at = reader.getItem(item);
      return new DataInputStream(new ByteArrayInputStream(bytes, at, bytes.length - at)).readUTF();
    }

    /** Returns where a constant ends: at the tag of the next, or where the pool ends. */
    int end(int item) {
      for (int next = item + 1; next < constants(); next++) {
        if (reader.getItem(next) != 0) {
          return reader.getItem(next) - 1;
        }
      }
      return reader.header;
    }
  }

  private final List<Content> classes = new ArrayList<>();
  private final SortedMap<String, Integer> strings = new TreeMap<>();

  private SolidClasses(SortedMap<String, byte[]> classFiles) throws IOException {
    List<Map.Entry<String, byte[]>> files = new ArrayList<>(classFiles.entrySet());
    files.sort(ORDER);
    for (Map.Entry<String, byte[]> file : files) {
      Content content = new Content(file.getValue());
      classes.add(content);
      for (int item = 1; item < content.constants(); item++) {
        if (content.tag(item) == Launcher.STRING) {
          strings.put(content.string(item), 0);
        }
      }
    }
    int number = 0;
    for (Map.Entry<String, Integer> string : strings.entrySet()) {
      string.setValue(number++);
    }
    if (number > Character.MAX_VALUE) {
      throw new IllegalArgumentException("the classes name " + number + " things, too many");
    }
  }

  /**
   * Returns the file.
   *
   * @param mainClass name of the class to start with
   * @param classFiles class files by path; not modified
   */
  public static byte[] of(String mainClass, SortedMap<String, byte[]> classFiles) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(bytes)) {
      out.writeUTF(mainClass);
      new SolidClasses(classFiles).write(out);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private void write(DataOutputStream out) throws IOException {
    out.writeInt(strings.size());
    for (String string : strings.keySet()) {
      out.writeUTF(string);
    }
    out.writeInt(classes.size());
    for (Content content : classes) {
      out.writeChar(number(content.reader().getClassName()));
      out.writeChar(content.constants());
      forEachConstant(content, (item, tag) -> out.writeByte(tag));
    }
    for (Content content : classes) {
      forEachConstant(content, (item, tag) -> writeName(content, item, tag, out));
    }
    for (Content content : classes) {
      forEachConstant(content, (item, tag) -> writeOthers(content, item, tag, out));
    }
    for (Content content : classes) {
      int rest = content.bytes().length - content.reader().header;
      out.writeInt(Launcher.HEADER + rest);
      out.write(content.bytes(), 0, Launcher.HEADER);
      out.write(content.bytes(), content.reader().header, rest);
    }
  }

  private interface ConstantWriter {
    void write(int item, int tag) throws IOException;
  }

  private static void forEachConstant(Content content, ConstantWriter writer) throws IOException {
    for (int item = 1; item < content.constants(); item++) {
      int tag = content.tag(item);
      if (tag != 0) {
        writer.write(item, tag);
      }
    }
  }

  private void writeName(Content content, int item, int tag, DataOutputStream out)
      throws IOException {
    if (tag == Launcher.STRING) {
      out.writeChar(number(content.string(item)));
    }
  }

  private static void writeOthers(Content content, int item, int tag, DataOutputStream out)
      throws IOException {
    if (tag != Launcher.STRING) {
      int at = content.reader().getItem(item);
      out.write(content.bytes(), at, content.end(item) - at);
    }
  }

  private int number(String string) {
    return Objects.requireNonNull(strings.get(string));
  }

  private static String packageOf(String path) {
    return path.substring(0, path.lastIndexOf('/') + 1);
  }
}
