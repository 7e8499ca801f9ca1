package org.mechservice.sim.build.javac;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.net.URLConnection;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.Enumeration;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import java.util.stream.Stream;
import org.mechservice.solver.api.Model;

/**
 * The files of solver-core as this process has them, wherever they are: a directory of classes or a
 * JAR, alone or with other modules.
 */
public final class SolverClasses {
  private static final String CLASSES = "org/mechservice/solver/";
  private static final String SERVICES = "META-INF/services/org.mechservice.solver.";

  private SolverClasses() {}

  /** Read once per process, when first needed. */
  private static final class Holder {
    private static final SortedMap<String, byte[]> FILES =
        Collections.unmodifiableSortedMap(read());
  }

  /** Returns all files by path, such as {@code org/mechservice/solver/api/Model.class}. */
  public static SortedMap<String, byte[]> files() {
    return Holder.FILES;
  }

  private static SortedMap<String, byte[]> read() {
    String self = Model.class.getName().replace('.', '/') + ".class";
    URL url = Model.class.getResource("/" + self);
    if (url == null) {
      throw new IllegalStateException("the solver's own class files cannot be read");
    }
    try {
      URLConnection connection = url.openConnection();
      return connection instanceof JarURLConnection jar
          ? readJar(jar)
          : readDirectory(Path.of(directory(url, self)));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (URISyntaxException e) {
      throw new IllegalStateException("the solver's own class files are at no usable place", e);
    }
  }

  private static URI directory(URL url, String self) throws URISyntaxException {
    String text = url.toString();
    return new URI(text.substring(0, text.length() - self.length()));
  }

  private static SortedMap<String, byte[]> readJar(JarURLConnection connection) throws IOException {
    SortedMap<String, byte[]> files = new TreeMap<>();
    connection.setUseCaches(false);
    try (JarFile jar = connection.getJarFile()) {
      Enumeration<JarEntry> entries = jar.entries();
      while (entries.hasMoreElements()) {
        JarEntry entry = entries.nextElement();
        if (isSolvers(entry.getName())) {
          try (InputStream stream = jar.getInputStream(entry)) {
            files.put(entry.getName(), stream.readAllBytes());
          }
        }
      }
    }
    return files;
  }

  private static SortedMap<String, byte[]> readDirectory(Path directory) throws IOException {
    SortedMap<String, byte[]> files = new TreeMap<>();
    for (Path path : filesBelow(directory)) {
      String name = directory.relativize(path).toString().replace('\\', '/');
      if (isSolvers(name)) {
        files.put(name, Files.readAllBytes(path));
      }
    }
    return files;
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
