package org.mechservice.sim.build.jar;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Map;
import java.util.SortedMap;

/**
 * Classes one after the other in one file, which compresses far better than many small ones; read
 * by the {@link org.mechservice.solver.standalone.Launcher} of a standalone JAR.
 */
public final class SolidClasses {
  private static final String CLASS = ".class";

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
      for (Map.Entry<String, byte[]> file : classFiles.entrySet()) {
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
}
