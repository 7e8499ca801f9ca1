package org.mechservice.solver.standalone;

import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.util.HashMap;
import java.util.Map;
import org.mechservice.solver.catalogue.MessageCode;

/**
 * Starts a standalone JAR. The solver's classes lie in one file, because many small files compress
 * badly; the model's own classes are ordinary entries of the JAR.
 *
 * <p>The file: the name of the main class; the number of strings, and those of all classes; the
 * number of classes; for each its name and its constant pool, with the numbers of strings in place
 * of strings; for each the number of its other bytes, and those.
 */
public final class Launcher extends ClassLoader {
  /** The file's place in the JAR. */
  public static final String SOLVER = "META-INF/mech.solver";

  /** Bytes of a class file before its constant pool. */
  public static final int HEADER = 8;

  /** Tag of a string in a constant pool. */
  public static final int STRING = 1;

  private final Map<String, byte[]> classes = new HashMap<>();
  private final String mainClass;

  private Launcher() throws IOException {
    super(getPlatformClassLoader());
    try (InputStream file = resource(SOLVER)) {
      mainClass = read(file, classes);
    }
  }

  /**
   * Reads the file.
   *
   * @param file not closed
   * @param classes class files by name are added
   * @return the name of the main class
   * @throws IOException if it is damaged
   */
  public static String read(InputStream file, Map<String, byte[]> classes) throws IOException {
    DataInputStream in = new DataInputStream(file);
    String mainClass = in.readUTF();
    String[] strings = new String[in.readInt()];
    for (int i = 0; i < strings.length; i++) {
      strings[i] = in.readUTF();
    }
    String[] names = new String[in.readInt()];
    byte[][] tags = new byte[names.length][];
    for (int i = 0; i < names.length; i++) {
      names[i] = strings[in.readChar()];
      tags[i] = tags(in);
    }
    int[][] named = new int[names.length][];
    for (int i = 0; i < names.length; i++) {
      named[i] = named(in, tags[i]);
    }
    byte[][] pools = new byte[names.length][];
    for (int i = 0; i < names.length; i++) {
      pools[i] = pool(in, tags[i], named[i], strings);
    }
    for (int i = 0; i < names.length; i++) {
      int length = in.readInt();
      ByteArrayOutputStream classFile = new ByteArrayOutputStream(pools[i].length + length);
      classFile.write(in.readNBytes(HEADER));
      classFile.write(pools[i]);
      classFile.write(in.readNBytes(length - HEADER));
      classes.put(names[i].replace('/', '.'), classFile.toByteArray());
    }
    return mainClass;
  }

  /** Reads the tags of a constant pool; 0 where there is no constant. */
  private static byte[] tags(DataInputStream in) throws IOException {
    byte[] tags = new byte[in.readChar()];
    for (int i = 1; i < tags.length; i++) {
      tags[i] = in.readByte();
      i += size(tags[i]) / 8; // What is as wide as a long counts twice.
    }
    return tags;
  }

  /** Reads which strings a constant pool has. */
  private static int[] named(DataInputStream in, byte[] tags) throws IOException {
    int[] named = new int[tags.length];
    for (int i = 1; i < tags.length; i++) {
      if (tags[i] == STRING) {
        named[i] = in.readChar();
      }
    }
    return named;
  }

  private static byte[] pool(DataInputStream in, byte[] tags, int[] named, String[] strings)
      throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    DataOutputStream out = new DataOutputStream(bytes);
    out.writeChar(tags.length);
    for (int i = 1; i < tags.length; i++) {
      if (tags[i] != 0) {
        out.writeByte(tags[i]);
      }
      if (tags[i] == STRING) {
        out.writeUTF(strings[named[i]]);
      } else if (tags[i] != 0) {
        out.write(in.readNBytes(size(tags[i])));
      }
    }
    return bytes.toByteArray();
  }

  /** Bytes of a constant that is no string, by its tag (JVM specification, 4.4). */
  private static int size(int tag) {
    return switch (tag) {
      case 5, 6 -> 8;
      case 15 -> 3;
      case 7, 8, 16, 19, 20 -> 2;
      default -> 4;
    };
  }

  private static InputStream resource(String name) throws IOException {
    InputStream found = Launcher.class.getClassLoader().getResourceAsStream(name);
    if (found == null) {
      throw new IOException(
          MessageCode.STANDALONE_JAR_DAMAGED + " the JAR is damaged: it has no " + name);
    }
    return found;
  }

  /** Runs the main class with the arguments given. */
  public static void main(String[] args) throws Throwable {
    Launcher loader = new Launcher();
    try {
      loader
          .loadClass(loader.mainClass)
          .getMethod("main", String[].class)
          .invoke(null, (Object) args);
    } catch (InvocationTargetException e) {
      throw e.getCause();
    }
  }

  @Override
  protected Class<?> findClass(String name) throws ClassNotFoundException {
    byte[] bytes = classes.remove(name);
    if (bytes == null) {
      try (InputStream own = resource(name.replace('.', '/') + ".class")) {
        bytes = own.readAllBytes();
      } catch (IOException e) {
        throw new ClassNotFoundException(name, e);
      }
    }
    return defineClass(name, bytes, 0, bytes.length);
  }
}
