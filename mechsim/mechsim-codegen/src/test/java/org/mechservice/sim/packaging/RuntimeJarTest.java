package org.mechservice.sim.packaging;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.jar.JarEntry;
import java.util.jar.JarFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.guard.SolverClasses;
import org.mechservice.solver.api.Solver;

/** The runtime JAR: an ordinary JAR of the whole solver, made once by the build. */
final class RuntimeJarTest {
  private static final JarImage MADE = RuntimeJar.make();

  @TempDir Path folder;

  @Test
  void buildHasMadeTheJarOfThisProcessesSolver() {
    Optional<JarImage> built = RuntimeJar.ofBuild();

    assertThat(built).isPresent();
    assertThat(built.get().sha256()).isEqualTo(MADE.sha256());
    assertThat(built.get().manifest()).isEqualTo(MADE.manifest());
  }

  @Test
  void sameSolverGivesTheSameBytes() {
    assertThat(RuntimeJar.make().bytes()).isEqualTo(MADE.bytes());
    assertThat(RuntimeJar.current()).isSameAs(RuntimeJar.current());
    assertThat(RuntimeJar.sha256()).isEqualTo(MADE.sha256());
  }

  @Test
  void holdsTheFourArtifactsOfTheSolverAsTheyAre() throws IOException {
    List<String> names = new ArrayList<>();
    try (JarFile jar = new JarFile(written().toFile(), true)) {
      for (JarEntry entry : jar.stream().toList()) {
        byte[] content = jar.getInputStream(entry).readAllBytes();
        names.add(entry.getName());
        if (!entry.getName().equals(JarFile.MANIFEST_NAME)) {
          assertThat(content).as(entry.getName()).isEqualTo(SolverClasses.file(entry.getName()));
        }
      }
    }
    assertThat(names)
        .startsWith(JarFile.MANIFEST_NAME)
        .contains(
            "META-INF/services/org.mechservice.solver.api.Solver",
            "org/mechservice/solver/api/Model.class",
            "org/mechservice/solver/text/CsvWriter.class",
            "org/mechservice/solver/linear/DenseLu.class",
            "org/mechservice/solver/ode/adams/De.class",
            "org/mechservice/solver/dynamics/recursion/TreeSteps.class",
            "org/mechservice/solver/simulation/Simulation.class",
            "org/mechservice/solver/standalone/RunModel.class");
  }

  /** Java verifies a class when it initialises it. */
  @Test
  void everyClassOfItIsValidAndTheSolverIsFoundAsAService() throws Exception {
    Path jar = written();
    try (URLClassLoader loader =
            new URLClassLoader(
                new URL[] {jar.toUri().toURL()}, ClassLoader.getPlatformClassLoader());
        JarFile entries = new JarFile(jar.toFile())) {
      List<String> classes =
          entries.stream().map(JarEntry::getName).filter(name -> name.endsWith(".class")).toList();
      for (String path : classes) {
        String name = path.substring(0, path.length() - ".class".length()).replace('/', '.');
        assertThat(Class.forName(name, true, loader).getName()).isEqualTo(name);
      }
      Class<?> solver = loader.loadClass(Solver.class.getName());
      assertThat(ServiceLoader.load(solver, loader).findFirst()).isPresent();
    }
  }

  private Path written() throws IOException {
    return Files.write(folder.resolve(MADE.fileName()), MADE.bytes());
  }
}
