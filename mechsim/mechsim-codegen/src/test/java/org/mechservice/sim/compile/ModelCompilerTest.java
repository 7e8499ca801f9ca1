package org.mechservice.sim.compile;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Collections;
import java.util.Set;
import java.util.SortedMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.sim.emit.bytes.MethodSizes;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.model.Scenes;

class ModelCompilerTest {
  private static SortedMap<String, byte[]> classFiles(String name) {
    MechmlModel model = Scenes.model(Scenes.timingModel(name).mechanism());
    BuildOptions options = new BuildOptions("auto", Set.of(), Scenes.SETTINGS);
    return ModelFactory.compile(model, options, ModelFactory.generate(model, options)).classFiles();
  }

  /** A method above 8 000 bytes is never compiled (docs/theory/formulations.md#methods). */
  @ParameterizedTest
  @ValueSource(strings = {"pend5s", "driver41", "chain200"})
  void noMethodIsTooLongForTheVirtualMachinesCompiler(String name) {
    byte[] classFile = classFiles(name).values().iterator().next();
    assertThat(MethodSizes.longest(classFile)).isLessThan(7000);
  }

  @Test
  void theSameSourceGivesTheSameBytes() {
    assertThat(classFiles("driver41").values().iterator().next())
        .isEqualTo(classFiles("driver41").values().iterator().next());
  }

  @Test
  void onlyTheSolversInterfacesAreOnTheClassPath() {
    for (String type :
        new String[] {
          "org.mechservice.sim.model.ModelFactory",
          "org.mechservice.solver.simulation.Simulation",
          "com.google.gson.Gson"
        }) {
      String source = "package org.mechservice.model; class A { " + type + " x; }";
      assertThatThrownBy(() -> compile(source))
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("does not compile");
    }
    assertThat(compile("package org.mechservice.model; class A { String s; }")).hasSize(1);
  }

  private static SortedMap<String, byte[]> compile(String source) {
    return ModelCompiler.compile("org.mechservice.model.A", source, Collections.emptySortedMap());
  }

  @Test
  void aClassTooLargeForAClassFileIsToldAsSuch() {
    StringBuilder source = new StringBuilder("package org.mechservice.model; class A { void a() {");
    for (int i = 0; i < 20000; i++) {
      source.append("System.out.println(").append(i).append(");");
    }
    assertThatThrownBy(() -> compile(source.append("}}").toString()))
        .hasMessageStartingWith("S-085");
  }

  @Test
  void theLongestMethodIsFound() {
    SortedMap<String, byte[]> classes =
        compile(
            "package org.mechservice.model; class A { int a; long b() { return 5000000000L; } }");
    // aload_0, invokespecial, return: 5 bytes; ldc2_w, lreturn: 4.
    assertThat(MethodSizes.longest(classes.values().iterator().next())).isEqualTo(5);
  }
}
