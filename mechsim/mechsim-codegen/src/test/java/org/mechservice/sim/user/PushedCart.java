package org.mechservice.sim.user;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.sim.compile.Compilation;

/** A cart of 2 kg on a rail, pushed by a class: {@code car.Push}. */
public final class PushedCart {
  /** What the class pushes with, N. */
  public static final double FORCE = 3;

  /** What its class leaves behind where it is loaded. */
  public static final String TRACE = "car.Push.wasLoaded";

  private PushedCart() {}

  /** Returns the model file. */
  public static byte[] file() {
    try (InputStream in =
        Objects.requireNonNull(PushedCart.class.getResourceAsStream("pushed.xml"))) {
      return in.readAllBytes();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }

  /** Returns the source of its force. */
  public static String source() {
    return """
    package car;

    import org.mechservice.solver.api.ForceDeclaration;
    import org.mechservice.solver.api.ForceLoads;
    import org.mechservice.solver.api.ForceState;
    import org.mechservice.solver.api.UserForce;

    public class Push implements UserForce {
      static {
        System.setProperty("car.Push.wasLoaded", "yes");
      }

      private int slide;

      public void declare(ForceDeclaration model) {
        slide = model.coordinate("slide", 0);
      }

      public void apply(ForceState state, ForceLoads loads) {
        loads.addJointForce(slide, 3);
      }
    }
    """;
  }

  /** Returns the source of its force without the trace, which a server does not let it leave. */
  public static String harmlessSource() {
    return source().replaceFirst("(?s) {2}static \\{.*?\\}\\n\\n", "");
  }

  /** Returns the force as a user file, source or class file. */
  public static UserFile asSource(String text) {
    return new UserFile("car/Push.java", text.getBytes(StandardCharsets.UTF_8));
  }

  /** Compiles a class of package {@code car} as a user does, for a version of Java. */
  public static UserFile compiled(String name, String text, String release) {
    SortedMap<String, byte[]> classes =
        Compilation.of(
                List.of(Compilation.source("car." + name, text)),
                List.of("--release", release, "-proc:none"),
                Set.of("org.mechservice.solver.api", "org.mechservice.solver.linear"),
                new TreeMap<>())
            .classFiles();
    return new UserFile(
        "car/" + name + ".class", Objects.requireNonNull(classes.get("car." + name)));
  }
}
