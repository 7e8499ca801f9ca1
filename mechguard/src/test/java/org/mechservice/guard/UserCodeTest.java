package org.mechservice.guard;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class UserCodeTest {
  @TempDir private Path work;
  private Path model;
  private Path forces;

  @BeforeEach
  void writeModel() throws IOException {
    model = Files.writeString(work.resolve("car.xml"), "<MechML/>");
    forces = Files.createDirectories(work.toRealPath().resolve("forces"));
  }

  @Test
  void classesAreFoundBySimpleNameAndInTheFolderOfTheirPackage() throws Exception {
    Path simple = Files.writeString(forces.resolve("Road.java"), "");
    Path own = Files.createDirectories(forces.resolve("car"));
    Path inPackage = Files.writeString(own.resolve("Road.class"), "");

    assertThat(UserCode.in(forces).files("car/Road")).containsExactly(simple, inPackage);
    assertThat(UserCode.in(forces).files("car/Wheel")).isEmpty();
    assertThat(UserCode.NONE.files("car/Road")).isEmpty();
  }

  @Test
  void linkOutOfTheFolderIsNoConsent() throws Exception {
    Path outside = Files.writeString(work.resolve("Secret.java"), "");
    Files.createSymbolicLink(forces.resolve("Road.java"), outside);
    assertThat(UserCode.in(forces).files("Road")).isEmpty();
  }

  @Test
  void codeBesideTheModelIsNamedWithTheWayToConsent() throws Exception {
    assertThat(UserCode.refusal(model, "Road")).isEmpty();
    Path beside = Files.writeString(work.toRealPath().resolve("Road.java"), "");
    assertThat(UserCode.refusal(model, "Road").orElseThrow())
        .contains(beside.toString(), "--user-code " + work.toRealPath(), "UserCode.in");
  }

  @Test
  void onlyConsentLetsClassesRunWithoutAWallAndItIsTold() {
    Confinement none = Confinement.none("nothing is installed");
    assertThat(UserCode.NONE.refusal(none).orElseThrow())
        .startsWith("S-168")
        .contains("nothing is installed", "--unconfined");
    assertThat(UserCode.NONE.warning(none)).isEmpty();
    assertThat(UserCode.NONE.unconfined().refusal(none)).isEmpty();
    assertThat(UserCode.NONE.unconfined().warning(none).orElseThrow())
        .contains("unconfined", "nothing is installed");
  }
}
