package org.mechservice.sim.compile;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.Collections;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.mechservice.guard.ModelClassLoader;
import org.mechservice.sim.emit.bytes.MethodSizes;

class CompactLocalsTest {
  private static double run(String body) throws ReflectiveOperationException {
    String source =
        "package org.mechservice.model; public class A { public static double a(double p, double[]"
            + " x) {"
            + body
            + "} }";
    ModelClassLoader loader =
        new ModelClassLoader(
            new TreeMap<>(
                ModelCompiler.compile(
                    "org.mechservice.model.A", source, Collections.emptySortedMap())),
            CompactLocalsTest.class.getClassLoader());
    Method method =
        loader.loadClass("org.mechservice.model.A").getMethod("a", double.class, double[].class);
    return (double) method.invoke(null, 3.0, new double[] {1, 2, 4});
  }

  @Test
  void parametersKeepTheirPlaces() throws ReflectiveOperationException {
    assertThat(run("double a = p + 1; double b = a * 2; double c = b - p; return c + p;"))
        .isEqualTo(8);
  }

  @Test
  void variablesThatALoopCarriesAreNotShared() throws ReflectiveOperationException {
    String loop =
        "double sum = 0; double twice = 2 * p; for (int i = 0; i < 3; i++) {"
            + " double term = twice * x[i]; sum = sum + term; } double end = sum; return end;";
    assertThat(run(loop)).isEqualTo(42);
  }

  @Test
  void integersAndReferencesAreNotOverwritten() throws ReflectiveOperationException {
    String mixed =
        "double a = x[0]; double[] y = x; double b = a + y[1]; int k = 2; double c = b + y[k];"
            + " double d = c + a; return d * k;";
    assertThat(run(mixed)).isEqualTo(16);
  }

  @Test
  void hundredsOfVariablesTakeShortAccesses() {
    StringBuilder body = new StringBuilder("double v0 = p;");
    for (int i = 1; i <= 400; i++) {
      body.append("double v").append(i).append(" = v").append(i - 1).append(" + p;");
    }
    String source =
        "package org.mechservice.model; class A { static double a(double p) {"
            + body
            + "return v400; } }";
    byte[] classFile =
        ModelCompiler.compile("org.mechservice.model.A", source, Collections.emptySortedMap())
            .values()
            .iterator()
            .next();
    // load, load, add, store: at most six bytes each.
    assertThat(MethodSizes.longest(classFile)).isLessThan(401 * 6);
  }
}
