package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.StringTokenizer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.guard.SolverClasses;

/** The fingerprint of the solver: it decides whether the runtime JAR of the build is used. */
final class SolverFingerprintTest {
  private static final String ONE = "org/mechservice/solver/standalone/RunModel.class";

  @TempDir Path directory;

  @Test
  void isTheSameInAJarAsInAFolder() throws Exception {
    assertThat(fingerprintIn(jar(true))).isEqualTo(SolverClasses.fingerprint());
  }

  @Test
  void isAnotherOnceOneByteOfOneClassIs() throws Exception {
    assertThat(fingerprintIn(jar(false))).isNotEqualTo(SolverClasses.fingerprint());
  }

  /** Returns a JAR of the solver; unless it is to be true, one byte of one class is changed. */
  private Path jar(boolean isTrue) throws Exception {
    ReproducibleJar jar = new ReproducibleJar(Map.of());
    SolverClasses.files().forEach(jar::add);
    if (!isTrue) {
      byte[] changed = Objects.requireNonNull(SolverClasses.file(ONE)).clone();
      changed[changed.length - 1] ^= 1;
      jar.add(ONE, changed);
    }
    return Files.write(directory.resolve("solver.jar"), jar.bytes());
  }

  /** Returns the fingerprint that a process with this JAR instead of the solver would find. */
  private static String fingerprintIn(Path jar) throws Exception {
    List<URL> places = new ArrayList<>(List.of(jar.toUri().toURL()));
    StringTokenizer classPath =
        new StringTokenizer(System.getProperty("java.class.path"), File.pathSeparator);
    while (classPath.hasMoreTokens()) {
      places.add(Path.of(classPath.nextToken()).toUri().toURL());
    }
    try (URLClassLoader process =
        new URLClassLoader(places.toArray(URL[]::new), ClassLoader.getPlatformClassLoader())) {
      Class<?> there = process.loadClass(SolverClasses.class.getName());
      return (String) there.getMethod("fingerprint").invoke(null);
    }
  }
}
