package org.mechservice.sim.model;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.Optional;
import java.util.SortedMap;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.jar.Sha256;
import org.mechservice.solver.pack.KeptClasses;
import org.mechservice.solver.pack.PackedClasses;

/** The runtime JAR of the build is the one that would be packed. */
final class BuiltRuntimeTest {
  private static final RuntimeJar PACKED = RuntimeJar.pack();

  @Test
  void buildHasPackedTheSolverOfThisProcess() {
    Optional<RuntimeJar> built = BuiltRuntime.find();

    assertThat(built).isPresent();
    assertThat(built.get().jar().sha256()).isEqualTo(PACKED.jar().sha256());
    assertThat(built.get().jar().manifest()).isEqualTo(PACKED.jar().manifest());
    assertThat(built.get().classes()).isEqualTo(PACKED.classes());
  }

  @Test
  void manifestTellsTheHashOfWhatClientsWillHaveUnpacked() throws IOException {
    SortedMap<String, byte[]> classes = ModelJarsTest.classesOf(PACKED.jar());

    assertThat(PACKED.jar().manifest())
        .containsEntry(PackedClasses.KEPT_SHA_256, Sha256.of(KeptClasses.write(classes)));
    assertThat(KeptClasses.read(KeptClasses.write(classes)).keySet()).isEqualTo(PACKED.classes());
  }
}
