package org.mechservice.sim.build.jar;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;

/**
 * Classes one after the other in one file, which compresses far better than many small ones, best
 * if like stands beside like; read by the {@link org.mechservice.solver.standalone.Launcher} of a
 * standalone JAR.
 */
public final class SolidClasses {
  private static final String CLASS = ".class";

  /** By package, in it by size: neighbours share names, and small classes are alike. */
  private static final Comparator<Map.Entry<String, byte[]>> ORDER =
      Comparator.comparing((Map.Entry<String, byte[]> file) -> packageOf(file.getKey()))
          .thenComparing(file -> file.getValue().length)
          .thenComparing(Map.Entry::getKey);

  private SolidClasses() {}

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
      out.writeInt(classFiles.size());
      List<Map.Entry<String, byte[]>> files = new ArrayList<>(classFiles.entrySet());
      files.sort(ORDER);
      for (Map.Entry<String, byte[]> file : files) {
        String path = file.getKey();
        out.writeUTF(path.substring(0, path.length() - CLASS.length()).replace('/', '.'));
        out.writeInt(file.getValue().length);
        out.write(file.getValue());
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return bytes.toByteArray();
  }

  private static String packageOf(String path) {
    return path.substring(0, path.lastIndexOf('/') + 1);
  }
}
