package org.mechservice.mechml;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.mechservice.solver.api.UserForce;
import org.mechservice.solver.force.user.UserForceSource;

/** The Java sources beside a model, compiled as the service does: nothing but the solver to see. */
final class CompiledSources {
  private CompiledSources() {}

  /** Compiles the sources of a folder into another one. */
  static UserForceSource compile(Path sources, Path classes) throws IOException {
    List<String> arguments =
        new ArrayList<>(
            List.of(
                "-d",
                classes.toString(),
                "-proc:none",
                "-Werror",
                "-Xlint:all",
                "-cp",
                UserForce.class.getProtectionDomain().getCodeSource().getLocation().getPath()));
    try (Stream<Path> files = Files.list(sources)) {
      files.filter(f -> f.toString().endsWith(".java")).map(Path::toString).forEach(arguments::add);
    }
    int errors =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, arguments.toArray(String[]::new));
    assertThat(errors).isZero();
    URLClassLoader loader = new URLClassLoader(new URL[] {classes.toUri().toURL()});
    return element -> {
      try {
        return (UserForce)
            loader.loadClass(element.className()).getDeclaredConstructor().newInstance();
      } catch (ReflectiveOperationException e) {
        throw new IllegalArgumentException(element.className(), e);
      }
    };
  }
}
