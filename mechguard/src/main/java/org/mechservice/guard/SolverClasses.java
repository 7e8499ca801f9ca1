package org.mechservice.guard;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import java.util.zip.CRC32;
import org.jspecify.annotations.Nullable;
import org.mechservice.solver.api.Model;
import org.mechservice.solver.linear.LinearSolver;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.simulation.Simulation;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.text.Sha256;

/**
 * The class files of the solver's five artifacts as this process has them, from a directory of
 * classes or a JAR, which may contain other modules too.
 */
public final class SolverClasses {
  private static final String CLASSES = "org/mechservice/solver/";

  /** One class of each artifact, which shows where the artifact is. */
  private static final List<Class<?>> ARTIFACTS =
      List.of(Model.class, LinearSolver.class, Scalar.class, Mechanism.class, Simulation.class);

  private static final String SERVICES = "META-INF/services/org.mechservice.solver.";

  private SolverClasses() {}

  /** Read once per process, when first needed. */
  private static final class Holder {
    private static final SortedMap<String, byte[]> FILES =
        Collections.unmodifiableSortedMap(each(SolverClasses::bytes, bytes -> bytes));
  }

  /** Reads a value from a file in a JAR. */
  @FunctionalInterface
  private interface Reading<T> {
    T of(JarFile jar, JarEntry entry) throws IOException;
  }

  /** Returns all files by path, such as {@code org/mechservice/solver/api/Model.class}. */
  public static SortedMap<String, byte[]> files() {
    return Holder.FILES;
  }

  /**
   * Returns one of the files by its path, or null if there is no such file; reads no other file.
   */
  public static byte @Nullable [] file(String path) {
    if (!isSolvers(path)) {
      return null;
    }
    try (InputStream file = Model.class.getResourceAsStream("/" + path)) {
      return file == null ? null : file.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Returns the SHA-256 of the paths, lengths and CRCs of all files. It changes when the solver is
   * compiled again. Only the table of contents of a JAR is read, because inflating and hashing the
   * files would take as long as a small simulation. It is no protection against forgery.
   */
  public static String fingerprint() {
    StringBuilder list = new StringBuilder();
    each((jar, entry) -> stamp(entry.getSize(), entry.getCrc()), SolverClasses::stamp)
        .forEach((path, stamp) -> list.append(path).append(' ').append(stamp).append('\n'));
    return Sha256.of(list.toString().getBytes(StandardCharsets.UTF_8));
  }

  private static byte[] bytes(JarFile jar, JarEntry entry) throws IOException {
    try (InputStream stream = jar.getInputStream(entry)) {
      return stream.readAllBytes();
    }
  }

  private static String stamp(byte[] content) {
    CRC32 crc = new CRC32();
    crc.update(content);
    return stamp(content.length, crc.getValue());
  }

  private static String stamp(long length, long crc) {
    return length + " " + crc;
  }

  /** Returns a value for each file, by path: from an entry of a JAR or from a file's content. */
  private static <T> SortedMap<String, T> each(Reading<T> inJar, Function<byte[], T> inDirectory) {
    SortedMap<String, T> found = new TreeMap<>();
    Set<String> read = new HashSet<>();
    for (Class<?> artifact : ARTIFACTS) {
      String self = artifact.getName().replace('.', '/') + ".class";
      URL url = artifact.getResource("/" + self);
      if (url == null) {
        throw new IllegalStateException("the solver's own class files cannot be read");
      }
      if (read.add(root(url, self))) {
        found.putAll(eachAt(url, self, inJar, inDirectory));
      }
    }
    return found;
  }

  private static <T> SortedMap<String, T> eachAt(
      URL url, String self, Reading<T> inJar, Function<byte[], T> inDirectory) {
    try {
      URLConnection connection = url.openConnection();
      return connection instanceof JarURLConnection jar
          ? eachIn(jar, inJar)
          : eachIn(Path.of(new URI(root(url, self))), inDirectory);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (URISyntaxException e) {
      throw new IllegalStateException("the solver's own class files are at no usable place", e);
    }
  }

  /** Returns the directory or JAR that a class file was found in. */
  private static String root(URL url, String self) {
    String text = url.toString();
    return text.substring(0, text.length() - self.length());
  }

  private static <T> SortedMap<String, T> eachIn(JarURLConnection connection, Reading<T> wanted)
      throws IOException {
    SortedMap<String, T> found = new TreeMap<>();
    connection.setUseCaches(false);
    try (JarFile jar = connection.getJarFile()) {
      for (JarEntry entry : Collections.list(jar.entries())) {
        if (isSolvers(entry.getName())) {
          found.put(entry.getName(), wanted.of(jar, entry));
        }
      }
    }
    return found;
  }

  private static <T> SortedMap<String, T> eachIn(Path directory, Function<byte[], T> wanted)
      throws IOException {
    SortedMap<String, T> found = new TreeMap<>();
    for (Path path : filesBelow(directory)) {
      String name = directory.relativize(path).toString().replace('\\', '/');
      if (isSolvers(name)) {
        found.put(name, wanted.apply(Files.readAllBytes(path)));
      }
    }
    return found;
  }

  private static List<Path> filesBelow(Path directory) throws IOException {
    try (Stream<Path> paths = Files.walk(directory)) {
      return paths.filter(Files::isRegularFile).toList();
    }
  }

  private static boolean isSolvers(String name) {
    boolean code = name.endsWith(".class") && !name.endsWith("package-info.class");
    return (name.startsWith(CLASSES) && code) || name.startsWith(SERVICES);
  }
}
