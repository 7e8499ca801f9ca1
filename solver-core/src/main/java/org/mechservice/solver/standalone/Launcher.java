package org.mechservice.solver.standalone;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.InvocationTargetException;
import java.util.HashMap;
import java.util.Map;

/**
 * Starts a standalone JAR. The solver's classes lie in one file, one after the other, because many
 * small files compress badly; the model's own classes are ordinary entries of the JAR.
 *
 * <p>The file: the name of the main class; the number of classes; for each its name, the number of
 * its bytes, and those.
 */
public final class Launcher extends ClassLoader {
  /** The file's place in the JAR. */
  public static final String SOLVER = "META-INF/mech.solver";

  private final Map<String, byte[]> classes = new HashMap<>();
  private final String mainClass;

  private Launcher() throws IOException {
    super(getPlatformClassLoader());
    try (InputStream file = resource(SOLVER);
        DataInputStream in = new DataInputStream(file)) {
      mainClass = in.readUTF();
      int count = in.readInt();
      for (int i = 0; i < count; i++) {
        classes.put(in.readUTF(), in.readNBytes(in.readInt()));
      }
    }
  }

  private static InputStream resource(String name) throws IOException {
    InputStream found = Launcher.class.getClassLoader().getResourceAsStream(name);
    if (found == null) {
      throw new IOException("S-069 the JAR is damaged: it has no " + name);
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
